// What limits a move, in words.

import { kindColours, limitColours } from "../../../core/colours";
import { limitKinds, moveKinds, type LimitKind } from "../../../run/segments";
import { texts } from "../../../texts";
import type { BlockTable } from "./block_table";

const words = texts.panels;

/** A limit and the letter of its axis; empty: none. */
export interface NamedLimit {
  kind: LimitKind | "dwell";
  letter: string;
}

export const DWELL: NamedLimit = { kind: "dwell", letter: "" };

/** "acceleration of Y" */
export function limitText({ kind, letter }: NamedLimit): string {
  if (kind === "joint_speed") return words.speedOf(letter);
  if (kind === "acceleration") return letter ? words.accelerationOf(letter) : words.limits.path_acceleration;
  return words.limits[kind];
}

/** What a programmer can do about it. */
export const limitHint = ({ kind }: NamedLimit): string => words.limitHints[kind];

export const limitColour = ({ kind }: NamedLimit): string =>
  kind === "dwell" ? kindColours.dwell : limitColours[kind];

/** What limits a block, where axes have these letters. */
export const limitOfBlock = (table: BlockTable, block: number, letters: readonly string[]): NamedLimit =>
  moveKinds[table.kind[block]] === "dwell" ? DWELL : limitOf(table.limit[block], table.axis[block], letters);

/** Of a segment's limit, where axes have these letters. */
export const limitOf = (limit: number, axis: number, letters: readonly string[]): NamedLimit => ({
  kind: limitKinds[limit],
  letter: letters[axis] ?? "",
});

/** From the words of a report (docs/report.md): "rotary B speed". */
export function limitOfReport(text: string): NamedLimit {
  if (text === "contour speed") return { kind: "path_speed", letter: "" };
  const [, letter, what] = /^(?:joint|rotary) (\S+) (speed|acceleration)$/.exec(text) ?? [];
  if (what) return { kind: what === "speed" ? "joint_speed" : "acceleration", letter };
  const kind = text.replaceAll(/[ -]/g, "_");
  return { kind: kind in words.limits ? (kind as LimitKind | "dwell") : "unknown", letter: "" };
}

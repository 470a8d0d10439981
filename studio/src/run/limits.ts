// What keeps a move from being faster: a limit, and the axis that it is of.

import { limitAxisOf, limitCodeOf, limitKinds, moveKinds, kindCodeOf, type LimitKind } from "./segments";

/** A dwell has no limit: it waits. */
export type Held = LimitKind | "dwell";

/** A limit and the letter of its axis; empty: none. */
export interface NamedLimit {
  kind: Held;
  letter: string;
}

export const DWELL: NamedLimit = { kind: "dwell", letter: "" };

/** By number, as limitKinds and axes with these letters count; -1: of no axis. */
export const limitOf = (limit: number, axis: number, letters: readonly string[]): NamedLimit => ({
  kind: limitKinds[limit],
  letter: letters[axis] ?? "",
});

/** Of a segment, by its flags. */
export const limitOfFlags = (flags: number, letters: readonly string[]): NamedLimit =>
  moveKinds[kindCodeOf(flags)] === "dwell" ? DWELL : limitOf(limitCodeOf(flags), limitAxisOf(flags), letters);

/** From the words of a report (docs/report.md): "rotary B speed". */
export function limitOfReport(text: string): NamedLimit {
  if (text === "contour speed") return { kind: "path_speed", letter: "" };
  const [, letter = "", what] = /^(?:joint|rotary)(?: (\S+))? (speed|acceleration)$/.exec(text) ?? [];
  if (what) return { kind: what === "speed" ? "joint_speed" : "acceleration", letter };
  const kind = text.replaceAll(/[ -]/g, "_");
  const known = kind === "dwell" || (limitKinds as readonly string[]).includes(kind);
  return { kind: known ? (kind as Held) : "unknown", letter: "" };
}

// What keeps a move from being faster: a limit, and the axis that it is of.

import { limitKinds, limitWords, moveKinds, type LimitKind } from "./kinds";
import { isRest, kindCodeOf, limitAxisOf, limitCodeOf } from "./segments";

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
  isRest(flags) || moveKinds[kindCodeOf(flags)] === "dwell" ? DWELL : limitOf(limitCodeOf(flags), limitAxisOf(flags), letters);

/** From the words of a report (docs/report.md): "rotary B speed". */
export function limitOfReport(text: string): NamedLimit {
  const [, letter = "", what] = /^(?:joint|rotary)(?: (\S+))? (speed|acceleration)$/.exec(text) ?? [];
  if (what) return { kind: what === "speed" ? "joint_speed" : "acceleration", letter };
  if (text === "dwell") return DWELL;
  return { kind: limitKinds.find((kind) => limitWords[kind] === text) ?? "unknown", letter: "" };
}

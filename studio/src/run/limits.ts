// Cause that keeps a move from being faster: a limit, and its axis.

import { limitKinds, limitWords, moveKinds, type LimitKind } from "./kinds";
import { isStandstill, decodeKind, decodeLimitAxis, decodeLimit } from "./segments";

/** Limit or dwell; a dwell has no limit, it waits. */
export type LimitOrDwell = LimitKind | "dwell";

/** Limit and the letter of its axis; empty: none. */
export interface NamedLimit {
  kind: LimitOrDwell;
  letter: string;
}

export const DWELL: NamedLimit = { kind: "dwell", letter: "" };

/** Returns a limit by number, in the order of limitKinds and of the axes with these letters; -1: no axis. */
export const toNamedLimit = (limit: number, axis: number, letters: readonly string[]): NamedLimit => ({
  kind: limitKinds[limit],
  letter: letters[axis] ?? "",
});

/** Returns the limit of a segment, by its flags. */
export const limitOfFlags = (flags: number, letters: readonly string[]): NamedLimit =>
  isStandstill(flags) || moveKinds[decodeKind(flags)] === "dwell" ? DWELL : toNamedLimit(decodeLimit(flags), decodeLimitAxis(flags), letters);

/** Returns a limit from the words of a report (docs/report.md): "rotary B speed". */
export function limitOfReport(text: string): NamedLimit {
  const [, letter = "", what] = /^(?:joint|rotary)(?: (\S+))? (speed|acceleration)$/.exec(text) ?? [];
  if (what) return { kind: what === "speed" ? "joint_speed" : "acceleration", letter };
  if (text === "dwell") return DWELL;
  return { kind: limitKinds.find((kind) => limitWords[kind] === text) ?? "unknown", letter: "" };
}

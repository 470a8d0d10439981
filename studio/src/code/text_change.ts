// Smallest change from one text to another, so that cursor, marks and the editor's own undo stay with the
// unchanged parts.

import type { Text } from "@codemirror/state";

export interface TextChange {
  from: number;
  to: number;
  insert: string;
}

/** Returns null if they are the same. Lines of `targetText` may have any line ends. */
export function textChange(present: Text, targetText: string): TextChange | null {
  const [before, after] = [present.toString(), targetText.replace(/\r\n?/g, "\n")];
  if (before === after) return null;
  const shorter = Math.min(before.length, after.length);
  let from = 0;
  while (from < shorter && before[from] === after[from]) ++from;
  let same = 0;
  while (same < shorter - from && before[before.length - 1 - same] === after[after.length - 1 - same]) ++same;
  return { from, to: before.length - same, insert: after.slice(from, after.length - same) };
}

// The least change that makes one text of another, so that cursor, marks and the editor's own undo stay with what is the same.

import type { Text } from "@codemirror/state";

export interface TextChange {
  from: number;
  to: number;
  insert: string;
}

/** Null: they are the same. Lines of `wanted` may end as they like. */
export function textChange(present: Text, wanted: string): TextChange | null {
  const [before, after] = [present.toString(), wanted.replace(/\r\n?/g, "\n")];
  if (before === after) return null;
  const shorter = Math.min(before.length, after.length);
  let from = 0;
  while (from < shorter && before[from] === after[from]) ++from;
  let same = 0;
  while (same < shorter - from && before[before.length - 1 - same] === after[after.length - 1 - same]) ++same;
  return { from, to: before.length - same, insert: after.slice(from, after.length - same) };
}

// Matches the lines of one text to those of another.

import type { SourceLines } from "./source_lines";

/**
 * For each line number of `after` the line of `before` that it matches, or was changed from; 0: it is new.
 */
export interface Matching {
  before: Uint32Array;
  /** 1 if the texts of a pair differ. */
  changed: Uint8Array;
}

/** Lines from `from` to before `to`. */
interface Range {
  from: number;
  to: number;
}

// Above this, the table for the longest common subsequence is too large.
const MAX_CELLS = 250_000;

class Differ {
  readonly found: Matching;

  constructor(
    private readonly a: SourceLines,
    private readonly b: SourceLines,
  ) {
    this.found = { before: new Uint32Array(b.count + 1), changed: new Uint8Array(b.count + 1) };
  }

  private same(a: number, b: number): boolean {
    return this.a.line(a) === this.b.line(b);
  }

  private pair(a: number, b: number, changed = false): void {
    this.found.before[b] = a;
    this.found.changed[b] = changed ? 1 : 0;
  }

  /** Removes equal lines at both ends, then searches for lines that occur once in both. */
  match(a: Range, b: Range): void {
    while (a.from < a.to && b.from < b.to && this.same(a.from, b.from)) this.pair(a.from++, b.from++);
    while (a.from < a.to && b.from < b.to && this.same(a.to - 1, b.to - 1)) this.pair(--a.to, --b.to);
    if (a.from === a.to || b.from === b.to) return;
    const anchors = (a.to - a.from) * (b.to - b.from) > MAX_CELLS ? this.unique(a, b) : this.common(a, b);
    if (anchors.length === 0) return this.change(a, b);
    let [lastA, lastB] = [a.from, b.from];
    for (const [indexA, indexB] of [...anchors, [a.to, b.to] as const]) {
      this.match({ from: lastA, to: indexA }, { from: lastB, to: indexB });
      if (indexB < b.to) this.pair(indexA, indexB);
      [lastA, lastB] = [indexA + 1, indexB + 1];
    }
  }

  /** Pairs the lines as changed if both ranges have the same number of lines. */
  private change(a: Range, b: Range): void {
    if (a.to - a.from !== b.to - b.from) return;
    for (let i = 0; i < a.to - a.from; ++i) this.pair(a.from + i, b.from + i, true);
  }

  /** Returns lines that occur once in both, as many as are in the same order (patience diff). */
  private unique(a: Range, b: Range): [number, number][] {
    const uniqueA = once(this.a, a);
    const uniqueB = once(this.b, b);
    const pairs: [number, number][] = [];
    for (const [text, indexA] of uniqueA) {
      const indexB = uniqueB.get(text);
      if (indexA > 0 && indexB !== undefined && indexB > 0) pairs.push([indexA, indexB]);
    }
    return longestIncreasing(pairs);
  }

  /** Returns the longest common subsequence, from a table. */
  private common(a: Range, b: Range): [number, number][] {
    const [rows, columns] = [a.to - a.from, b.to - b.from];
    const textA = Array.from({ length: rows }, (_, i) => this.a.line(a.from + i));
    const textB = Array.from({ length: columns }, (_, j) => this.b.line(b.from + j));
    const width = columns + 1;
    const longest = new Uint32Array((rows + 1) * width);
    for (let i = rows - 1; i >= 0; --i) {
      for (let j = columns - 1; j >= 0; --j) {
        longest[i * width + j] =
          textA[i] === textB[j]
            ? longest[(i + 1) * width + j + 1] + 1
            : Math.max(longest[(i + 1) * width + j], longest[i * width + j + 1]);
      }
    }
    const pairs: [number, number][] = [];
    for (let [i, j] = [0, 0]; i < rows && j < columns; ) {
      if (textA[i] === textB[j]) pairs.push([a.from + i++, b.from + j++]);
      else if (longest[(i + 1) * width + j] >= longest[i * width + j + 1]) ++i;
      else ++j;
    }
    return pairs;
  }
}

/** Returns the number of each line by its text; 0: it occurs more than once. */
function once(lines: SourceLines, { from, to }: Range): Map<string, number> {
  const found = new Map<string, number>();
  for (let number = from; number < to; ++number) {
    const text = lines.line(number);
    found.set(text, found.has(text) ? 0 : number);
  }
  return found;
}

/** Returns the longest part of pairs, in order of the first number, with rising second numbers. */
function longestIncreasing(pairs: [number, number][]): [number, number][] {
  const ends: number[] = [];
  const previous = new Int32Array(pairs.length).fill(-1);
  pairs.forEach(([, second], i) => {
    let [low, high] = [0, ends.length];
    while (low < high) {
      const middle = (low + high) >> 1;
      if (pairs[ends[middle]][1] < second) low = middle + 1;
      else high = middle;
    }
    if (low > 0) previous[i] = ends[low - 1];
    ends[low] = i;
  });
  const chosen: [number, number][] = [];
  for (let i = ends.at(-1) ?? -1; i >= 0; i = previous[i]) chosen.push(pairs[i]);
  return chosen.reverse();
}

export function matchLines(before: SourceLines, after: SourceLines): Matching {
  const differ = new Differ(before, after);
  differ.match({ from: 1, to: before.count + 1 }, { from: 1, to: after.count + 1 });
  return differ.found;
}

// Curves over more of a long run than is loaded at a time: from the path data of each block.

import type { Segments } from "../../run/segments";
import { push, type Curves } from "./curves";
import { PATH, type Group } from "./probe";

/** Max number of stretches fetched for exact curves: some 65,000 segments. */
const MOST_STRETCHES = 4;

/** True if a stretch of time has more data than exact curves are drawn from. */
export function isTooMuch(segments: Segments, from_s: number, to_s: number): boolean {
  return segments.isLong && lackingWithin(segments, from_s, to_s, MOST_STRETCHES + 1) > MOST_STRETCHES;
}

/** Returns the number of stretches that may have to be fetched; counted up to `most`. */
function lackingWithin({ stretches }: Segments, from_s: number, to_s: number, most: number): number {
  let count = 0;
  for (const { whole, start_s, end_s } of stretches) {
    if (!whole && start_s <= to_s && end_s >= from_s && ++count >= most) return count;
  }
  return count;
}

/** Fetches what exact curves lack. */
export function fetchWithin(segments: Segments, from_s: number, to_s: number): void {
  for (const stretch of segments.stretches) {
    if (stretch.whole || stretch.start_s > to_s || stretch.end_s < from_s || segments.locate(stretch.first)) continue;
    void segments.need(stretch.first);
  }
}

/** Returns the lowest and highest mean speed of blocks for each column of pixels; no other values. */
export function overviewOf(segments: Segments, group: Group, width: number, from_s: number, to_s: number, columns: number): Curves {
  const curves: Curves = { t_s: [], values: Array.from({ length: width }, () => []), areColumns: true };
  if (group !== "path") return curves;
  const step_s = (to_s - from_s) / columns;
  const low = new Float64Array(columns).fill(Infinity);
  const high = new Float64Array(columns).fill(-Infinity);
  for (const stretch of segments.stretches) {
    if (stretch.start_s > to_s || stretch.end_s < from_s) continue;
    let before_s = stretch.start_s;
    for (let i = 0; i < stretch.vertices; ++i) {
      const time_s = stretch.time_s(i);
      const first = Math.max(Math.floor((before_s - from_s) / step_s), 0);
      const last = Math.min(Math.floor((time_s - from_s) / step_s), columns - 1);
      const speed = first <= last ? stretch.speedOf_mm_s(i) : 0;
      for (let column = first; column <= last; ++column) {
        if (speed < low[column]) low[column] = speed;
        if (speed > high[column]) high[column] = speed;
      }
      before_s = time_s;
    }
  }
  const point = new Float64Array(width).fill(NaN);
  for (let column = 0; column < columns; ++column) {
    const t_s = from_s + (column + 0.25) * step_s;
    for (const speed of [low[column], high[column]]) {
      point[PATH.speed] = Number.isFinite(speed) ? speed : NaN;
      push(curves, t_s, point);
    }
  }
  return curves;
}

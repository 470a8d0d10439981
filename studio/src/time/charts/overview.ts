// Curves over more of a long run than is loaded at a time: from the path data of each block.

import type { Segments } from "../../run/segments";
import { push, type Curves } from "./curves";
import { PATH, type Group } from "./curve_sampler";

/** Max number of stretches fetched for exact curves: some 65,000 segments. */
const MAX_MISSING_SECTIONS = 4;

/** True if a stretch of time has more data than exact curves are drawn from. */
export function needsOverview(segments: Segments, from_s: number, to_s: number): boolean {
  return segments.isLong && countMissing(segments, from_s, to_s, MAX_MISSING_SECTIONS + 1) > MAX_MISSING_SECTIONS;
}

/** Returns the number of stretches that may have to be fetched; counted up to `most`. */
function countMissing({ sections }: Segments, from_s: number, to_s: number, most: number): number {
  let count = 0;
  for (const { whole, start_s, end_s } of sections) {
    if (!whole && start_s <= to_s && end_s >= from_s && ++count >= most) return count;
  }
  return count;
}

/** Fetches what exact curves lack. */
export function fetchRange(segments: Segments, from_s: number, to_s: number): void {
  for (const section of segments.sections) {
    if (section.whole || section.start_s > to_s || section.end_s < from_s || segments.locate(section.first)) continue;
    void segments.fetchNow(section.first);
  }
}

/** Returns the lowest and highest mean speed of blocks for each column of pixels; no other values. */
export function overviewCurves(segments: Segments, group: Group, width: number, from_s: number, to_s: number, columns: number): Curves {
  const curves: Curves = { t_s: [], values: Array.from({ length: width }, () => []), areColumns: true };
  if (group !== "path") return curves;
  const step_s = (to_s - from_s) / columns;
  const low = new Float64Array(columns).fill(Infinity);
  const high = new Float64Array(columns).fill(-Infinity);
  for (const section of segments.sections) {
    if (section.start_s > to_s || section.end_s < from_s) continue;
    let before_s = section.start_s;
    for (let i = 0; i < section.vertices; ++i) {
      const time_s = section.time_s(i);
      const first = Math.max(Math.floor((before_s - from_s) / step_s), 0);
      const last = Math.min(Math.floor((time_s - from_s) / step_s), columns - 1);
      const speed = first <= last ? section.vertexSpeed_mm_s(i) : 0;
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

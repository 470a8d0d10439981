// Curves over a stretch of time: exact samples for few segments, lowest and highest values for each column of
// pixels for many.

import type { Segments } from "../../run/segments";
import type { ExtremaTree } from "./extrema_tree";
import { AFTER_S, type CurveSampler, type SegmentRef } from "./curve_sampler";

/** Instants of the run (s) in order, and a value for each channel there; NaN: none. */
export interface Curves {
  t_s: number[];
  values: number[][];
  /** True if values come in pairs, the lowest and the highest of a column of pixels. */
  areColumns: boolean;
}

const empty = (width: number, areColumns = false): Curves => ({
  t_s: [],
  values: Array.from({ length: width }, () => []),
  areColumns,
});

export function push(curves: Curves, t_s: number, values: ArrayLike<number>): void {
  curves.t_s.push(t_s);
  for (let j = 0; j < curves.values.length; ++j) curves.values[j].push(values[j]);
}

/** Returns the curves. `columns`: width of the stretch in pixels. Data that is not loaded is left out. */
export function createCurves(segments: Segments, leaves: ExtremaTree, from_s: number, to_s: number, columns: number): Curves {
  const first = segments.at(from_s);
  if (first < 0 || !(to_s > from_s)) return empty(leaves.probe.width);
  const last = segments.at(to_s);
  const step_s = (to_s - from_s) / columns;
  if (last - first < columns / 4) return is_sampled(leaves.probe, first, last, from_s, to_s, step_s);
  if (!leaves.ready) return samplePerColumn(segments, leaves.probe, from_s, columns, step_s);
  return columnExtremes(segments, leaves, from_s, columns, step_s);
}

function is_sampled(probe: CurveSampler, first: number, last: number, from_s: number, to_s: number, step_s: number): Curves {
  const curves = empty(probe.width);
  const point = new Float64Array(probe.width);
  for (let index = first; index <= last; ++index) {
    const segmentRef = probe.segmentRef(index);
    if (!segmentRef) continue;
    const start_s = segmentRef.chunk.start_s[segmentRef.i];
    const begin_s = Math.max(from_s - start_s, 0);
    const end_s = Math.min(to_s - start_s, segmentRef.part.duration_s);
    if (!(end_s > begin_s)) continue;
    for (const t_s of instants(probe, segmentRef, begin_s, end_s, step_s)) {
      probe.put(segmentRef, t_s, point);
      push(curves, start_s + t_s, point);
    }
  }
  return curves;
}

/** Returns one instant a pixel, and both sides of each change of a law. */
function instants(probe: CurveSampler, segmentRef: SegmentRef, begin_s: number, end_s: number, step_s: number): number[] {
  const all = [begin_s, end_s];
  for (let t_s = begin_s + step_s; t_s < end_s; t_s += step_s) all.push(t_s);
  for (const t_s of probe.breaks_s(segmentRef)) {
    if (t_s > begin_s && t_s + AFTER_S < end_s) all.push(t_s, t_s + AFTER_S);
  }
  return all.sort((a, b) => a - b);
}

/** Returns one value a pixel, until the extremes are known. */
function samplePerColumn(segments: Segments, probe: CurveSampler, from_s: number, columns: number, step_s: number): Curves {
  const curves = empty(probe.width);
  const point = new Float64Array(probe.width);
  for (let column = 0; column < columns; ++column) {
    const t_s = from_s + (column + 0.5) * step_s;
    const segmentRef = probe.segmentRef(segments.at(t_s));
    if (!segmentRef) continue;
    probe.put(segmentRef, t_s - segmentRef.chunk.start_s[segmentRef.i], point);
    push(curves, t_s, point);
  }
  return curves;
}

function columnExtremes(segments: Segments, leaves: ExtremaTree, from_s: number, columns: number, step_s: number): Curves {
  const curves = empty(leaves.probe.width, true);
  const low = new Float32Array(leaves.probe.width);
  const high = new Float32Array(leaves.probe.width);
  let here = segments.at(from_s);
  for (let column = 0; column < columns; ++column) {
    const begin_s = from_s + column * step_s;
    const next = segments.at(begin_s + step_s);
    low.fill(Infinity);
    high.fill(-Infinity);
    extendBySegment(leaves.probe, here, begin_s, begin_s + step_s, low, high);
    leaves.expand(here + 1, next, low, high);
    if (next > here) extendBySegment(leaves.probe, next, begin_s, begin_s + step_s, low, high);
    // Not in the middle, because a chart may round that to either side and leave a column empty.
    push(curves, begin_s + step_s / 4, low);
    push(curves, begin_s + step_s / 4, high);
    here = next;
  }
  for (const values of curves.values) {
    for (let i = 0; i < values.length; ++i) if (!Number.isFinite(values[i])) values[i] = NaN;
  }
  return curves;
}

/** Widens by a segment that is partly in a column; one shorter than a column counts completely in both. */
function extendBySegment(
  probe: CurveSampler,
  index: number,
  from_s: number,
  to_s: number,
  low: Float32Array,
  high: Float32Array,
): void {
  const segmentRef = probe.segmentRef(index);
  if (!segmentRef) return;
  const start_s = segmentRef.chunk.start_s[segmentRef.i];
  const begin_s = Math.max(from_s - start_s, 0);
  const end_s = Math.min(to_s - start_s, segmentRef.part.duration_s);
  if (!(end_s > begin_s)) return;
  if (segmentRef.part.duration_s <= to_s - from_s) probe.expand(segmentRef, low, high, 0);
  else probe.widenWithin(segmentRef, begin_s, end_s, low, high, 0);
}

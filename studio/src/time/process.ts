// When the process (jet, spindle, torch) is on.

import { Flag } from "../run/evaluate";
import type { Segments } from "../run/segments";

/** Stretches of time one behind the other, as start and end in turn (s). */
export function processOn_s(segments: Segments): Float64Array {
  const edges: number[] = [];
  let on = false;
  for (const { count, flags, start_s } of segments.chunks) {
    for (let i = 0; i < count; ++i) {
      const now = (flags[i] & Flag.processOn) !== 0;
      if (now === on) continue;
      edges.push(start_s[i]);
      on = now;
    }
  }
  if (on) edges.push(segments.end_s);
  return Float64Array.from(edges);
}

/** Whether it is on somewhere from one instant to another. */
export function isOnWithin(edges_s: Float64Array, from_s: number, to_s: number): boolean {
  let [low, high] = [0, edges_s.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (edges_s[middle] <= from_s) low = middle + 1;
    else high = middle;
  }
  return low % 2 === 1 || (low < edges_s.length && edges_s[low] < to_s);
}

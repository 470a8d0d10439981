// Times with the process (jet, spindle, torch) on.

import { Flag } from "../run/kinds";
import { lastIndex } from "../run/search";
import type { Segments } from "../run/segments";

/** Returns consecutive stretches of time, as start and end in turn (s). */
export function processEdges_s(segments: Segments): Float64Array {
  const edges: number[] = [];
  let on = false;
  const addInterval = (flags: number, start_s: number) => {
    const now = (flags & Flag.processOn) !== 0;
    if (now !== on) edges.push(start_s);
    on = now;
  };
  for (const { count, flags, start_s } of segments.chunks) {
    for (let i = 0; i < count; ++i) addInterval(flags[i], start_s[i]);
  }
  for (const section of segments.sections.slice(segments.chunks.length)) {
    const { vertices, start_s } = section;
    for (let i = 0; i < vertices; ++i) addInterval(section.vertexFlags(i), i > 0 ? section.time_s(i - 1) : start_s);
  }
  if (on) edges.push(segments.end_s);
  return Float64Array.from(edges);
}

/** True if it is on at some time between two instants. */
export function isProcessOnWithin(edges_s: Float64Array, from_s: number, to_s: number): boolean {
  const next = lastIndex(edges_s.length, (i) => edges_s[i] <= from_s) + 1;
  return next % 2 === 1 || (next < edges_s.length && edges_s[next] < to_s);
}

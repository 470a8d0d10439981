// Time of each line of a file in a run, over all its passes.

import type { Robot } from "../run/run";

export interface LineTimes {
  /** By line, from 1 on. */
  times_s: Float64Array;
  slowest_s: number;
}

function lastLine(robot: Robot, file: number): number {
  let last = 0;
  for (const { count, file: files, line } of robot.segments.chunks) {
    for (let i = 0; i < count; ++i) if (files[i] === file && line[i] > last) last = line[i];
  }
  return last;
}

/**
 * Computes the times in one pass over all loaded segments; the caller keeps the result as long as the run is
 * shown.
 */
export function lineTimes(robot: Robot, file: number): LineTimes {
  const times_s = new Float64Array(lastLine(robot, file) + 1);
  for (const { count, file: files, line, duration_s } of robot.segments.chunks) {
    for (let i = 0; i < count; ++i) if (files[i] === file) times_s[line[i]] += duration_s[i];
  }
  let slowest_s = 0;
  for (const time_s of times_s) if (time_s > slowest_s) slowest_s = time_s;
  return { times_s, slowest_s };
}

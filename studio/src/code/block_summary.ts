// Summary of a line in a run: its blocks, their time and length, their speed and its limits.

import { limitOfFlags, type NamedLimit } from "../run/limits";
import type { Robot } from "../run/run";

export interface BlockSummary {
  /** How often the line ran. */
  passes: number;
  time_s: number;
  length_mm: number;
  /** The highest speed along the path. */
  peak_mm_s: number;
  /** The limit that was active for the longest time. */
  limit: NamedLimit;
}

/** Max number of segments of a line; further ones are ignored in its summary. */
const MAX_SEGMENTS = 20_000;

/** Returns true if a line has run, but not all its data are loaded. */
export function isSummaryIncomplete({ blocks, segments }: Robot, file: number, line: number): boolean {
  return segments.isLong && !blocks.behindTable({ file, line }).next().done;
}

/** Returns null if the line has not run, or not all its data are loaded. */
export function blockSummary(robot: Robot, file: number, line: number): BlockSummary | null {
  const { blocks, segments, letters } = robot;
  const numbers = blocks.blocksOfLine(file, line);
  if (numbers.length === 0 || isSummaryIncomplete(robot, file, line)) return null;
  const summary = { passes: numbers.length, time_s: 0, length_mm: 0, peak_mm_s: 0 };
  const held = new Map<string, { time_s: number; limit: NamedLimit }>();
  let seen = 0;
  for (const number of numbers) {
    const end = blocks.end(number);
    for (let i = blocks.first(number); i < end && seen < MAX_SEGMENTS; ++i, ++seen) {
      const [chunk, at] = segments.locate(i)!;
      const limit = limitOfFlags(chunk.flags[at], letters);
      const key = `${limit.kind} ${limit.letter}`;
      const sum = held.get(key) ?? { time_s: 0, limit };
      sum.time_s += chunk.duration_s[at];
      held.set(key, sum);
      summary.time_s += chunk.duration_s[at];
      summary.length_mm += chunk.length_mm[at];
      summary.peak_mm_s = Math.max(summary.peak_mm_s, segments.peakSpeed(chunk, at));
    }
    if (seen >= MAX_SEGMENTS) break;
  }
  const most = [...held.values()].reduce((best, one) => (one.time_s > best.time_s ? one : best));
  return { ...summary, limit: most.limit };
}

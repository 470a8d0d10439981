// What a run says of a line: its blocks, their time and length, how fast they went and what held them back.

import type { Robot } from "../run/run";
import type { LimitKind } from "../run/segments";

export interface BlockFacts {
  /** How often the line ran. */
  passes: number;
  time_s: number;
  length_mm: number;
  /** The highest speed along the path. */
  peak_mm_s: number;
  limit: LimitKind;
  /** Letter of the axis whose limit it is; "": of none. */
  limitAxis: string;
}

/** Beyond so many segments of a line the rest is left out of what is told of it. */
const ENOUGH = 20_000;

interface Held {
  time_s: number;
  limit: LimitKind;
  axis: number;
}

/** Null: the line has not run. */
export function blockFacts(robot: Robot, file: number, line: number): BlockFacts | null {
  const { blocks, segments } = robot;
  const numbers = blocks.ofLine(file, line);
  if (numbers.length === 0) return null;
  const facts = { passes: numbers.length, time_s: 0, length_mm: 0, peak_mm_s: 0 };
  const held = new Map<string, Held>();
  let seen = 0;
  for (const number of numbers) {
    const block = blocks.get(number);
    for (let i = block.first; i < block.first + block.count && seen < ENOUGH; ++i, ++seen) {
      const { limit, limitAxis, duration_s, length_mm } = segments.info(i);
      const key = `${limit} ${limitAxis}`;
      const sum = held.get(key) ?? { time_s: 0, limit, axis: limitAxis };
      sum.time_s += duration_s;
      held.set(key, sum);
      facts.time_s += duration_s;
      facts.length_mm += length_mm;
      facts.peak_mm_s = Math.max(facts.peak_mm_s, segments.peakSpeed(i));
    }
    if (seen >= ENOUGH) break;
  }
  const most = [...held.values()].reduce((best, one) => (one.time_s > best.time_s ? one : best));
  return { ...facts, limit: most.limit, limitAxis: robot.scene.axes[most.axis]?.letter ?? "" };
}

/** When the block of a line begins that is nearest to a time; -1: the line has not run. */
export function startNearest_s(robot: Robot, file: number, line: number, t_s: number): number {
  const numbers = robot.blocks.ofLine(file, line);
  if (numbers.length === 0) return -1;
  const start_s = (i: number) => {
    const [chunk, at] = robot.segments.locate(robot.blocks.first.at(numbers[i]));
    return chunk.start_s[at];
  };
  let [low, high] = [0, numbers.length - 1];
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (start_s(middle) <= t_s) low = middle;
    else high = middle - 1;
  }
  const before_s = start_s(low);
  if (robot.blocks.get(numbers[low]).end_s >= t_s) return before_s;
  const after_s = low + 1 < numbers.length ? start_s(low + 1) : Infinity;
  return Math.abs(after_s - t_s) < Math.abs(t_s - before_s) ? after_s : before_s;
}

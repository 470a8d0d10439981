// Comparison of two runs, line by line.

import type { Robot, Run } from "../../../run/run";
import { cachedBlockTable } from "./block_table";
import { matchLines } from "./diff";
import { largestIndices } from "./largest_indices";
import { linesOf } from "./source_lines";

export type Change = "same" | "changed" | "new" | "gone";

export interface Row {
  change: Change;
  /** Current position; for removed lines, the previous one. */
  file: string;
  line: number;
  text: string;
  before_s: number;
  after_s: number;
}

export interface Comparison {
  before_s: number;
  after_s: number;
  /** Lines that are new, removed or have another time, the largest difference first; `most` of them. */
  rows: Row[];
  /** How many there are. */
  count: number;
}

/** Limit (s) below which two times count as the same. */
export const MIN_DIFFERENCE_S = 1e-6;

/** Returns the time of each line, for each file. */
function lineTimes(run: Run, robot: Robot): Float64Array[] {
  const table = cachedBlockTable(robot);
  const times = robot.files.map((file) => new Float64Array(linesOf(run.sources, file).count + 1));
  for (let block = 0; block < table.count; ++block) {
    const of = times[table.file[block]];
    if (of && table.line[block] < of.length) of[table.line[block]] += table.duration_s[block];
  }
  return times;
}

/**
 * Returns the file of the previous run that corresponds to this one: by the same name, or as the program of
 * its run.
 */
export function counterpart(name: string, index: number, before: Robot, after: Robot): number {
  const found = before.files.indexOf(name);
  if (found >= 0 || index > 0) return found;
  return after.files.includes(before.files[0]) ? -1 : 0;
}

/** All lines that differ, as columns. */
class Differences {
  readonly changes: Change[] = [];
  readonly files: number[] = [];
  readonly lines: number[] = [];
  readonly before_s: number[] = [];
  readonly after_s: number[] = [];

  add(change: Change, file: number, line: number, before_s: number, after_s: number): void {
    this.changes.push(change);
    this.files.push(file);
    this.lines.push(line);
    this.before_s.push(before_s);
    this.after_s.push(after_s);
  }

  absDifference_s(i: number): number {
    return Math.abs(this.after_s[i] - this.before_s[i]);
  }
}

/** Compares the robot with this number in both runs; returns null if one of them does not have it. */
export function compare(beforeRun: Run, afterRun: Run, robot: number, most: number): Comparison | null {
  const [before, after] = [beforeRun.robots[robot], afterRun.robots[robot]];
  if (!before || !after) return null;
  const all = new Differences();
  const [timesBefore, timesAfter] = [lineTimes(beforeRun, before), lineTimes(afterRun, after)];
  const used = timesBefore.map((times) => new Uint8Array(times.length));
  after.files.forEach((file, index) => {
    const lines = linesOf(afterRun.sources, file);
    const other = counterpart(file, index, before, after);
    const matching = other >= 0 ? matchLines(linesOf(beforeRun.sources, before.files[other]), lines) : null;
    for (let line = 1; line <= lines.count; ++line) {
      const from = matching?.before[line] ?? 0;
      const before_s = from > 0 ? timesBefore[other][from] : 0;
      const after_s = timesAfter[index][line];
      if (from > 0) used[other][from] = 1;
      if (Math.abs(after_s - before_s) < MIN_DIFFERENCE_S) continue;
      all.add(from === 0 ? "new" : matching!.changed[line] ? "changed" : "same", index, line, before_s, after_s);
    }
  });
  timesBefore.forEach((times, index) =>
    times.forEach((before_s, line) => {
      if (before_s >= MIN_DIFFERENCE_S && !used[index][line]) all.add("gone", index, line, before_s, 0);
    }),
  );
  const count = all.lines.length;
  const { indices } = largestIndices(count, most, (i) => all.absDifference_s(i), () => true);
  const rows = Array.from(indices, (i): Row => {
    const gone = all.changes[i] === "gone";
    const file = (gone ? before : after).files[all.files[i]];
    const text = linesOf((gone ? beforeRun : afterRun).sources, file).line(all.lines[i]);
    const times = { before_s: all.before_s[i], after_s: all.after_s[i] };
    return { change: all.changes[i], file, line: all.lines[i], text, ...times };
  });
  return { before_s: before.segments.end_s, after_s: after.segments.end_s, rows, count };
}

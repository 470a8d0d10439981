// Which block of one run is which of another: that of the same line, at the same pass over it. Where texts differ, lines
// are those that stand in both, or that have been changed in their places.

import type { Robot, Run } from "../../../run/run";
import { blockTableOf } from "../../results/data/block_table";
import { counterpart } from "../../results/data/comparison";
import { matchLines, type Matching } from "../../results/data/diff";
import { linesOf } from "../../results/data/source_lines";

/** One robot of a run. */
export interface Side {
  run: Run;
  robot: Robot;
}

/** Files of two runs that are compared with each other, by name. */
export interface FilePair {
  a: string;
  b: string;
}

export interface BlockMatching {
  /** For each block of one run that of the other; -1: that has none. */
  ofA: Int32Array;
  ofB: Int32Array;
  /** For each block of b at which pass over its line it is, from 0; and of a. */
  passA: Uint32Array;
  passB: Uint32Array;
  /** 1 where a block of b comes from a line that reads otherwise in a. */
  changed: Uint8Array;
  /** Pairs whose texts differ; those where a text is not in the page, so that lines count by their numbers. */
  otherTexts: FilePair[];
  unread: FilePair[];
}

/** At which pass over its line each block is, from 0. */
function passesOf(robot: Robot): Uint32Array {
  const { count, file, line } = blockTableOf(robot);
  const last = robot.files.map(() => 0);
  for (let block = 0; block < count; ++block) last[file[block]] = Math.max(last[file[block]] ?? 0, line[block]);
  const counts = last.map((most) => new Uint32Array(most + 1));
  return Uint32Array.from({ length: count }, (_, block) => counts[file[block]][line[block]]++);
}

/** How lines of a file of b are those of a: by number, or by text. */
interface OfFile {
  /** -1: there is none in a. */
  file: number;
  /** Null: by number. */
  lines: Matching | null;
}

function matchFiles(a: Side, b: Side, found: BlockMatching): OfFile[] {
  return b.robot.files.map((name, index) => {
    const file = counterpart(name, index, a.robot, b.robot);
    if (file < 0) return { file, lines: null };
    const pair = { a: a.robot.files[file], b: name };
    if (!a.run.sources.has(pair.a) || !b.run.sources.has(name)) {
      if (pair.a !== name) found.unread.push(pair);
      return { file, lines: null };
    }
    const [before, after] = [linesOf(a.run.sources, pair.a), linesOf(b.run.sources, name)];
    if (before.text === after.text) return { file, lines: null };
    found.otherTexts.push(pair);
    return { file, lines: matchLines(before, after) };
  });
}

export function matchBlocks(a: Side, b: Side): BlockMatching {
  const [tableA, tableB] = [blockTableOf(a.robot), blockTableOf(b.robot)];
  const found: BlockMatching = {
    ofA: new Int32Array(tableA.count).fill(-1),
    ofB: new Int32Array(tableB.count).fill(-1),
    passA: passesOf(a.robot),
    passB: passesOf(b.robot),
    changed: new Uint8Array(tableB.count),
    otherTexts: [],
    unread: [],
  };
  const files = matchFiles(a, b, found);
  for (let block = 0; block < tableB.count; ++block) {
    const { file, lines } = files[tableB.file[block]] ?? { file: -1, lines: null };
    const line = tableB.line[block];
    const lineA = lines ? lines.before[line] : line;
    if (file < 0 || !lineA) continue;
    const blockA = a.robot.blocks.ofLine(file, lineA)[found.passB[block]] ?? -1;
    if (blockA < 0) continue;
    found.ofB[block] = blockA;
    found.ofA[blockA] = block;
    found.changed[block] = lines?.changed[line] ?? 0;
  }
  return found;
}

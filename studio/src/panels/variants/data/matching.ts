// Matches the blocks of two runs: same line, same pass over it. If texts differ, lines match if they occur in
// both, or if they were changed in place.

import type { Robot, Run } from "../../../run/run";
import { cachedBlockTable } from "../../results/data/block_table";
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
  /** For each block of one run the block of the other; -1: none. */
  blocksOfA: Int32Array;
  blocksOfB: Int32Array;
  /** Pass over its line for each block, from 0, in a and in b. */
  passA: Uint32Array;
  passB: Uint32Array;
  /** 1 if a block of b comes from a line with another text in a. */
  changed: Uint8Array;
  /**
   * Pairs with different texts; and pairs with a text that is not in the page, so that lines are matched by
   * number.
   */
  otherTexts: FilePair[];
  unloadedTexts: FilePair[];
}

/** Returns the pass over its line for each block, from 0. */
function blockPasses(robot: Robot): Uint32Array {
  const { count, file, line } = cachedBlockTable(robot);
  const last = robot.files.map(() => 0);
  for (let block = 0; block < count; ++block) last[file[block]] = Math.max(last[file[block]] ?? 0, line[block]);
  const counts = last.map((most) => new Uint32Array(most + 1));
  return Uint32Array.from({ length: count }, (_, block) => counts[file[block]][line[block]]++);
}

/** Match between the lines of a file of b and those of a: by number, or by text. */
interface FileMatch {
  /** -1: no such file in a. */
  file: number;
  /** Null: by number. */
  lines: Matching | null;
}

function matchFiles(a: Side, b: Side, found: BlockMatching): FileMatch[] {
  return b.robot.files.map((name, index) => {
    const file = counterpart(name, index, a.robot, b.robot);
    if (file < 0) return { file, lines: null };
    const pair = { a: a.robot.files[file], b: name };
    if (!a.run.sources.has(pair.a) || !b.run.sources.has(name)) {
      if (pair.a !== name) found.unloadedTexts.push(pair);
      return { file, lines: null };
    }
    const [before, after] = [linesOf(a.run.sources, pair.a), linesOf(b.run.sources, name)];
    if (before.text === after.text) return { file, lines: null };
    found.otherTexts.push(pair);
    return { file, lines: matchLines(before, after) };
  });
}

export function matchBlocks(a: Side, b: Side): BlockMatching {
  const [tableA, tableB] = [cachedBlockTable(a.robot), cachedBlockTable(b.robot)];
  const found: BlockMatching = {
    blocksOfA: new Int32Array(tableA.count).fill(-1),
    blocksOfB: new Int32Array(tableB.count).fill(-1),
    passA: blockPasses(a.robot),
    passB: blockPasses(b.robot),
    changed: new Uint8Array(tableB.count),
    otherTexts: [],
    unloadedTexts: [],
  };
  const files = matchFiles(a, b, found);
  for (let block = 0; block < tableB.count; ++block) {
    const { file, lines } = files[tableB.file[block]] ?? { file: -1, lines: null };
    const line = tableB.line[block];
    const lineA = lines ? lines.before[line] : line;
    if (file < 0 || !lineA) continue;
    const blockA = a.robot.blocks.blocksOfLine(file, lineA)[found.passB[block]] ?? -1;
    if (blockA < 0) continue;
    found.blocksOfB[block] = blockA;
    found.blocksOfA[blockA] = block;
    found.changed[block] = lines?.changed[line] ?? 0;
  }
  return found;
}

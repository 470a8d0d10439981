// Differences of two runs: in total, and block by block.

import type { Robot, Run } from "../../../run/run";
import { cachedBlockTable, type BlockTable } from "../../results/data/block_table";
import { MIN_DIFFERENCE_S } from "../../results/data/comparison";
import { largestIndices } from "../../results/data/largest_indices";
import { linesOf } from "../../results/data/source_lines";
import { matchBlocks, type BlockMatching, type Side } from "./matching";
import type { StartBlock } from "./variants_file";

export type RowKind = "both" | "changed" | "onlyA" | "onlyB";

/** Block with different times in the two runs. */
export interface Row {
  kind: RowKind;
  /** Position in a; in b for a block that only b has. */
  file: string;
  line: number;
  text: string;
  /** Number of the pass over the line, from 1, and the number of passes. */
  pass: number;
  passes: number;
  /** Block number in each run; -1: none. */
  blocks: [number, number];
  times_s: [number, number];
}

/** True if a run came to its end, so that its time is that of the program. */
export const isCompleteRun = ({ report, error }: Run): boolean =>
  error === null && (report?.status === "completed" || report?.status === "violations");

/** Returns the block of a position in a run; -1: the run never reaches it. */
export function blockOf({ files, blocks }: Robot, { file, line, pass }: StartBlock): number {
  return blocks.blocksOfLine(files.indexOf(file), line)[pass - 1] ?? -1;
}

/** Returns the block at which the times of a run start; -1: the run never reaches it. */
function startBlock(from: StartBlock | null, own: Robot, other: Robot, matched: Int32Array): number {
  if (!from) return 0;
  const block = blockOf(own, from);
  if (block >= 0 || own.files.includes(from.file)) return block;
  const otherBlock = blockOf(other, from);
  return otherBlock < 0 ? -1 : matched[otherBlock];
}

export class Differences {
  readonly matching: BlockMatching;
  private readonly tables: [BlockTable, BlockTable];
  /** First counted block of each run; -1: it never reaches the start of the count. */
  readonly startBlocks: [number, number];
  /** When that is, s. */
  readonly starts_s: [number, number];
  /** Times from there to the end of each run, s. */
  readonly totals_s: [number, number];
  /**
   * Part of the difference in blocks that one of the runs, or both, have; the remainder is between blocks.
   */
  readonly blockDifference_s: number;
  private readonly blocksOfA: Int32Array;
  private readonly blocksOfB: Int32Array;

  constructor(
    readonly a: Side,
    readonly b: Side,
    readonly from: StartBlock | null = null,
  ) {
    this.matching = matchBlocks(a, b);
    this.tables = [cachedBlockTable(a.robot), cachedBlockTable(b.robot)];
    const { blocksOfA, blocksOfB } = this.matching;
    this.startBlocks = [startBlock(from, a.robot, b.robot, blocksOfB), startBlock(from, b.robot, a.robot, blocksOfA)];
    const starts = [a, b].map(({ robot }, i) => (from && this.startBlocks[i] >= 0 ? robot.blocks.start_s(this.startBlocks[i]) : 0));
    this.starts_s = [starts[0], starts[1]];
    this.totals_s = [a.run.end_s - starts[0], b.run.end_s - starts[1]];
    [this.blocksOfA, this.blocksOfB] = this.pairs();
    this.blockDifference_s = this.blocksOfA.reduce((sum, _, i) => sum + this.difference_s(i), 0);
  }

  /** True if both runs reach the start of the count. */
  get reachesStart(): boolean {
    return this.startBlocks[0] >= 0 && this.startBlocks[1] >= 0;
  }

  /** Difference of b from a; below 0: b is faster. */
  get total_s(): number {
    return this.totals_s[1] - this.totals_s[0];
  }

  /** Returns all counted blocks, with matching blocks as one pair. */
  private pairs(): [Int32Array, Int32Array] {
    if (!this.reachesStart) return [new Int32Array(0), new Int32Array(0)];
    const [beginA, beginB] = this.startBlocks;
    const { blocksOfA, blocksOfB } = this.matching;
    const pairs: [number[], number[]] = [[], []];
    const add = (a: number, b: number) => (pairs[0].push(a), pairs[1].push(b));
    for (let b = beginB; b < blocksOfB.length; ++b) add(blocksOfB[b] >= beginA ? blocksOfB[b] : -1, b);
    for (let a = beginA; a < blocksOfA.length; ++a) if (blocksOfA[a] < beginB) add(a, -1);
    return [Int32Array.from(pairs[0]), Int32Array.from(pairs[1])];
  }

  private time_s(side: 0 | 1, block: number): number {
    return block >= 0 ? this.tables[side].duration_s[block] : 0;
  }

  private difference_s(pair: number): number {
    return this.time_s(1, this.blocksOfB[pair]) - this.time_s(0, this.blocksOfA[pair]);
  }

  /** Returns the rows that differ and match `words`, the largest difference first; at most `most`. */
  rows(most: number, words = ""): { rows: Row[]; count: number } {
    const lets = this.filter(words);
    const differs = (pair: number) => Math.abs(this.difference_s(pair)) >= MIN_DIFFERENCE_S && lets(pair);
    const { indices, passed } = largestIndices(this.blocksOfA.length, most, (pair) => Math.abs(this.difference_s(pair)), differs);
    return { rows: Array.from(indices, (pair) => this.row(pair)), count: passed };
  }

  /**
   * Returns the few blocks with the largest part of the difference: those that change in the same direction
   * as the total.
   */
  largestDifferences(most: number): Row[] {
    const way = Math.sign(this.total_s);
    const share_s = (pair: number) => way * this.difference_s(pair);
    const { indices } = largestIndices(this.blocksOfA.length, most, share_s, (pair) => share_s(pair) >= MIN_DIFFERENCE_S);
    return Array.from(indices, (pair) => this.row(pair));
  }

  /** "230": that line; "200-260": lines; other words: part of the line's text. */
  private filter(words: string): (pair: number) => boolean {
    const queryText = words.trim().toLowerCase();
    if (queryText === "") return () => true;
    const [, from, to = from] = /^(\d+)(?:\s*-\s*(\d+))?$/.exec(queryText) ?? [];
    if (from) return (pair) => this.lineOf(pair) >= Number(from) && this.lineOf(pair) <= Number(to);
    const texts = [this.a, this.b].map(({ run, robot }) => robot.files.map((file) => linesOf(run.sources, file).linesWith(queryText)));
    return (pair) => {
      const [side, block] = this.standing(pair);
      const table = this.tables[side];
      return texts[side][table.file[block]]?.[table.line[block]] === 1;
    };
  }

  /** Returns the run that has the line of a pair: a, if it has it. */
  private standing(pair: number): [side: 0 | 1, block: number] {
    return this.blocksOfA[pair] >= 0 ? [0, this.blocksOfA[pair]] : [1, this.blocksOfB[pair]];
  }

  private lineOf(pair: number): number {
    const [side, block] = this.standing(pair);
    return this.tables[side].line[block];
  }

  private row(pair: number): Row {
    const [a, b] = [this.blocksOfA[pair], this.blocksOfB[pair]];
    const [side, block] = this.standing(pair);
    const { run, robot } = side === 0 ? this.a : this.b;
    const [file, line] = [this.tables[side].file[block], this.tables[side].line[block]];
    const name = robot.files[file] ?? "";
    return {
      kind: a < 0 ? "onlyB" : b < 0 ? "onlyA" : this.matching.changed[b] ? "changed" : "both",
      file: name,
      line,
      text: linesOf(run.sources, name).line(line),
      pass: (side === 0 ? this.matching.passA : this.matching.passB)[block] + 1,
      passes: robot.blocks.blocksOfLine(file, line).length,
      blocks: [a, b],
      times_s: [this.time_s(0, a), this.time_s(1, b)],
    };
  }
}

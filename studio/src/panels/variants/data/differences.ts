// What two runs differ in: as a whole, and block by block.

import type { Robot, Run } from "../../../run/run";
import { blockTableOf, type BlockTable } from "../../results/data/block_table";
import { SAME_S } from "../../results/data/comparison";
import { greatest } from "../../results/data/greatest";
import { linesOf } from "../../results/data/source_lines";
import { matchBlocks, type BlockMatching, type Side } from "./matching";
import type { From } from "./variants_file";

export type RowKind = "both" | "changed" | "onlyA" | "onlyB";

/** A block that takes another time in one run than in the other. */
export interface Row {
  kind: RowKind;
  /** Where it stands in a; of one that b alone has, there. */
  file: string;
  line: number;
  text: string;
  /** At which pass over the line, from 1, and how many there are. */
  pass: number;
  passes: number;
  /** By number in each run; -1: it has none. */
  blocks: [number, number];
  times_s: [number, number];
}

/** Whether a run came to its end, so that its time is that of the program. */
export const isWhole = ({ report, failure }: Run): boolean =>
  failure === null && (report?.status === "completed" || report?.status === "violations");

/** The block that a place means in a run; -1: the run never comes there. */
export function blockOf({ files, blocks }: Robot, { file, line, pass }: From): number {
  return blocks.ofLine(files.indexOf(file), line)[pass - 1] ?? -1;
}

/** Where a run's times count from; -1: it never comes there. */
function beginOf(from: From | null, own: Robot, other: Robot, matched: Int32Array): number {
  if (!from) return 0;
  const block = blockOf(own, from);
  if (block >= 0 || own.files.includes(from.file)) return block;
  const there = blockOf(other, from);
  return there < 0 ? -1 : matched[there];
}

export class Differences {
  readonly matching: BlockMatching;
  private readonly tables: [BlockTable, BlockTable];
  /** The first block of each that counts; -1: it never comes to the place that times count from. */
  readonly begins: [number, number];
  /** When that is, s. */
  readonly starts_s: [number, number];
  /** From there to the end of each run, s. */
  readonly totals_s: [number, number];
  /** How much of the difference is in blocks that one of the runs, or both, have; the rest is between blocks. */
  readonly inBlocks_s: number;
  private readonly ofA: Int32Array;
  private readonly ofB: Int32Array;

  constructor(
    readonly a: Side,
    readonly b: Side,
    readonly from: From | null = null,
  ) {
    this.matching = matchBlocks(a, b);
    this.tables = [blockTableOf(a.robot), blockTableOf(b.robot)];
    const { ofA, ofB } = this.matching;
    this.begins = [beginOf(from, a.robot, b.robot, ofB), beginOf(from, b.robot, a.robot, ofA)];
    const starts = [a, b].map(({ robot }, i) => (from && this.begins[i] >= 0 ? robot.blocks.start_s(this.begins[i]) : 0));
    this.starts_s = [starts[0], starts[1]];
    this.totals_s = [a.run.end_s - starts[0], b.run.end_s - starts[1]];
    [this.ofA, this.ofB] = this.pairs();
    this.inBlocks_s = this.ofA.reduce((sum, _, i) => sum + this.difference_s(i), 0);
  }

  /** Whether both runs come to where times count from. */
  get isReached(): boolean {
    return this.begins[0] >= 0 && this.begins[1] >= 0;
  }

  /** b against a; below 0: b is faster. */
  get total_s(): number {
    return this.totals_s[1] - this.totals_s[0];
  }

  /** All blocks that count, those that belong together as one. */
  private pairs(): [Int32Array, Int32Array] {
    if (!this.isReached) return [new Int32Array(0), new Int32Array(0)];
    const [beginA, beginB] = this.begins;
    const { ofA, ofB } = this.matching;
    const pairs: [number[], number[]] = [[], []];
    const add = (a: number, b: number) => (pairs[0].push(a), pairs[1].push(b));
    for (let b = beginB; b < ofB.length; ++b) add(ofB[b] >= beginA ? ofB[b] : -1, b);
    for (let a = beginA; a < ofA.length; ++a) if (ofA[a] < beginB) add(a, -1);
    return [Int32Array.from(pairs[0]), Int32Array.from(pairs[1])];
  }

  private time_s(side: 0 | 1, block: number): number {
    return block >= 0 ? this.tables[side].duration_s[block] : 0;
  }

  private difference_s(pair: number): number {
    return this.time_s(1, this.ofB[pair]) - this.time_s(0, this.ofA[pair]);
  }

  /** Those that differ and that `words` let through, the greatest difference first; `most` of them. */
  rows(most: number, words = ""): { rows: Row[]; count: number } {
    const lets = this.filter(words);
    const differs = (pair: number) => Math.abs(this.difference_s(pair)) >= SAME_S && lets(pair);
    const { indices, passed } = greatest(this.ofA.length, most, (pair) => Math.abs(this.difference_s(pair)), differs);
    return { rows: Array.from(indices, (pair) => this.row(pair)), count: passed };
  }

  /** The few blocks that make the most of the difference: those that go the way that the whole goes. */
  foremost(most: number): Row[] {
    const way = Math.sign(this.total_s);
    const share_s = (pair: number) => way * this.difference_s(pair);
    const { indices } = greatest(this.ofA.length, most, share_s, (pair) => share_s(pair) >= SAME_S);
    return Array.from(indices, (pair) => this.row(pair));
  }

  /** "230": that line; "200-260": lines; other words: a part of the line's text. */
  private filter(words: string): (pair: number) => boolean {
    const wanted = words.trim().toLowerCase();
    if (wanted === "") return () => true;
    const [, from, to = from] = /^(\d+)(?:\s*-\s*(\d+))?$/.exec(wanted) ?? [];
    if (from) return (pair) => this.lineOf(pair) >= Number(from) && this.lineOf(pair) <= Number(to);
    const texts = [this.a, this.b].map(({ run, robot }) => robot.files.map((file) => linesOf(run.sources, file).matching(wanted)));
    return (pair) => {
      const [side, block] = this.standing(pair);
      const table = this.tables[side];
      return texts[side][table.file[block]]?.[table.line[block]] === 1;
    };
  }

  /** The run in which a pair has its line: a, where that has it. */
  private standing(pair: number): [side: 0 | 1, block: number] {
    return this.ofA[pair] >= 0 ? [0, this.ofA[pair]] : [1, this.ofB[pair]];
  }

  private lineOf(pair: number): number {
    const [side, block] = this.standing(pair);
    return this.tables[side].line[block];
  }

  private row(pair: number): Row {
    const [a, b] = [this.ofA[pair], this.ofB[pair]];
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
      passes: robot.blocks.ofLine(file, line).length,
      blocks: [a, b],
      times_s: [this.time_s(0, a), this.time_s(1, b)],
    };
  }
}

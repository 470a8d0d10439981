// Blocks of a run: consecutive segments from the same line. A line that runs again, in a loop or a
// subprogram, is another block. Blocks of permanently loaded segments are in a table; after the table, a
// block's number counts segments up to its first one.

import { SAME_TIME_S } from "./report";
import { lastIndex } from "./search";
import type { Segments } from "./segments";
import type { Chunk, Line } from "./run_section";

export interface Block {
  file: number;
  line: number;
  /** First segment, and number of segments. */
  first: number;
  count: number;
  start_s: number;
  end_s: number;
}

export class Blocks {
  private readonly firstSegments = new GrowableArray(Uint32Array);
  /** Blocks in the table by file and line; made on first use. */
  private byLine: Map<number, LineIndex> | null = null;
  private lastFile = -1;
  private lastLine = -1;
  /** Segments that the table has. */
  private segmentsInTable = 0;

  constructor(private readonly segments: Segments) {}

  /** How many the table has. */
  get tabled(): number {
    return this.firstSegments.length;
  }

  add(chunk: Chunk): void {
    for (let i = 0; i < chunk.count; ++i) {
      const [file, line] = [chunk.file[i], chunk.line[i]];
      if (file === this.lastFile && line === this.lastLine) continue;
      [this.lastFile, this.lastLine] = [file, line];
      this.firstSegments.push(chunk.first + i);
    }
    this.byLine = null;
    this.segmentsInTable = chunk.first + chunk.count;
  }

  get(block: number): Block {
    const first = this.first(block);
    const end = this.end(block);
    return { ...this.segments.lineOf(first), first, count: end - first, start_s: this.start_s(block), end_s: this.end_s(block) };
  }

  /** The block of a segment. */
  of(segment: number): number {
    if (segment < this.segmentsInTable) return lastIndex(this.tabled, (block) => this.firstSegments.at(block) <= segment);
    return this.parseNumber(this.about(segment)[0]);
  }

  private parseNumber(first: number): number {
    return this.tabled + first - this.segmentsInTable;
  }

  /** Returns the range of a block after the table: its first segment, and the one after its last. */
  private about(segment: number): [number, number] {
    const { segments } = this;
    const line = segments.lineOf(segment);
    const isOf = (other: number) => {
      const own = segments.lineOf(other);
      return own.file === line.file && own.line === line.line;
    };
    let [begin, end] = segments.sectionOf(segment).blockAround(segment);
    while (begin > this.segmentsInTable && isOf(begin - 1)) [begin] = segments.sectionOf(begin - 1).blockAround(begin - 1);
    while (end < segments.count && isOf(end)) [, end] = segments.sectionOf(end).blockAround(end);
    return [begin, end];
  }

  /** Its first segment. */
  first(block: number): number {
    return block < this.tabled ? this.firstSegments.at(block) : this.segmentsInTable + block - this.tabled;
  }

  /** Returns the segment after its last. */
  end(block: number): number {
    if (block >= this.tabled) return this.about(this.first(block))[1];
    return block + 1 < this.tabled ? this.firstSegments.at(block + 1) : this.segmentsInTable;
  }

  /** Returns the next block; -1: it is the last. */
  after(block: number): number {
    const end = this.end(block);
    return end < this.segments.count ? this.of(end) : -1;
  }

  /** Returns the previous block; -1: it is the first. */
  before(block: number): number {
    return block > 0 ? this.of(this.first(block) - 1) : -1;
  }

  start_s(block: number): number {
    return this.segments.start_s(this.first(block));
  }

  end_s(block: number): number {
    return this.segments.segmentEnd_s(this.end(block) - 1);
  }

  /** Returns the blocks in the table that come from a line, in the order of time. */
  blocksOfLine(file: number, line: number): Uint32Array {
    this.byLine ??= this.sortByLine();
    return this.byLine.get(file)?.of(line) ?? new Uint32Array();
  }

  private sortByLine(): Map<number, LineIndex> {
    const lines = new Map<number, [blocks: GrowableArray, lines: GrowableArray]>();
    for (let block = 0; block < this.tabled; ++block) {
      const { file, line } = this.segments.lineOf(this.firstSegments.at(block));
      const [blocks, of] = lines.get(file) ?? [new GrowableArray(Uint32Array), new GrowableArray(Uint32Array)];
      lines.set(file, [blocks, of]);
      blocks.push(block);
      of.push(line);
    }
    return new Map([...lines].map(([file, [blocks, of]]) => [file, new LineIndex(blocks, of)]));
  }

  /** Returns the blocks of a line after the table. */
  *behindTable(line: Line): Generator<number> {
    const { sections, chunks } = this.segments;
    let end = 0;
    for (let i = chunks.length; i < sections.length; ++i) {
      for (const segment of sections[i].segmentsOf(line)) {
        if (segment < end) continue;
        const about = this.about(segment);
        end = about[1];
        yield this.parseNumber(about[0]);
      }
    }
  }

  /** Returns the first block that comes from a line; -1: it moves nothing. */
  firstOf(file: number, line: number): number {
    return this.blocksOfLine(file, line)[0] ?? (this.behindTable({ file, line }).next().value as number | undefined) ?? -1;
  }

  /**
   * Returns the block of a line active at an instant, else the one with the nearest start; -1: it moves
   * nothing.
   */
  nearest(file: number, line: number, t_s: number): number {
    const found = [this.nearestInTable(file, line, t_s), ...this.nearBlocksAfterTable({ file, line }, t_s)].filter((block) => block >= 0);
    const timeDistance_s = (block: number) => {
      const start_s = this.start_s(block);
      return t_s >= start_s && t_s <= this.end_s(block) ? -1 : Math.abs(t_s - start_s);
    };
    return found.length < 2 ? (found[0] ?? -1) : found.reduce((best, block) => (timeDistance_s(block) < timeDistance_s(best) ? block : best));
  }

  private nearestInTable(file: number, line: number, t_s: number): number {
    const blocks = this.blocksOfLine(file, line);
    if (blocks.length === 0) return -1;
    const before = lastIndex(blocks.length, (i) => this.start_s(blocks[i]) <= t_s + SAME_TIME_S);
    const here = blocks[Math.max(before, 0)];
    if (before < 0 || before + 1 === blocks.length || this.end_s(here) >= t_s - SAME_TIME_S) return here;
    const next = blocks[before + 1];
    return this.start_s(next) - t_s < t_s - this.start_s(here) ? next : here;
  }

  /** Returns the blocks in the nearest stretches on both sides that contain the line. */
  private nearBlocksAfterTable(line: Line, t_s: number): number[] {
    const { sections, chunks } = this.segments;
    const here = Math.max(lastIndex(sections.length, (i) => sections[i].start_s <= t_s), chunks.length);
    const blocksOfSection = (i: number) => [...new Set([...(sections[i]?.segmentsOf(line) ?? [])].map((segment) => this.of(segment)))];
    let [before, behind] = [here, here + 1];
    while (before >= chunks.length && blocksOfSection(before).length === 0) --before;
    while (behind < sections.length && blocksOfSection(behind).length === 0) ++behind;
    return [...(before >= chunks.length ? blocksOfSection(before) : []), ...blocksOfSection(behind)];
  }
}

/** Numbers of blocks line by line, in order: an object for each line would take ten times the memory. */
class LineIndex {
  private readonly starts: Uint32Array;
  private readonly sorted: Uint32Array;

  constructor(blocks: GrowableArray, lines: GrowableArray) {
    let last = 0;
    for (let i = 0; i < lines.length; ++i) last = Math.max(last, lines.at(i));
    this.starts = new Uint32Array(last + 2);
    for (let i = 0; i < lines.length; ++i) ++this.starts[lines.at(i) + 1];
    for (let line = 0; line <= last; ++line) this.starts[line + 1] += this.starts[line];
    this.sorted = new Uint32Array(blocks.length);
    const next = this.starts.slice();
    for (let i = 0; i < blocks.length; ++i) this.sorted[next[lines.at(i)]++] = blocks.at(i);
  }

  of(line: number): Uint32Array {
    return this.sorted.subarray(this.starts[line] ?? 0, this.starts[line + 1] ?? 0);
  }
}

/** A typed array that grows. */
class GrowableArray {
  length = 0;
  private values: Uint32Array;

  constructor(private readonly type: typeof Uint32Array) {
    this.values = new type(1024);
  }

  push(value: number): void {
    if (this.length === this.values.length) {
      const more = new this.type(2 * this.length);
      more.set(this.values);
      this.values = more;
    }
    this.values[this.length++] = value;
  }

  at(index: number): number {
    return this.values[index];
  }
}

// The blocks of a run: segments one behind the other that come from the same line. A line that runs again, in a
// loop or a subprogram, is another block.

import { SAME_TIME_S } from "./report";
import { lastIndex } from "./search";
import type { Chunk, Segments } from "./segments";

export interface Block {
  file: number;
  line: number;
  /** Its first segment, and how many it has. */
  first: number;
  count: number;
  start_s: number;
  end_s: number;
  length_mm: number;
}

export class Blocks {
  readonly first = new Growing(Uint32Array);
  /** For each file and line the number of each of its blocks. */
  private readonly byLine = new Map<number, Map<number, number[]>>();
  private lastFile = -1;
  private lastLine = -1;

  constructor(private readonly segments: Segments) {}

  get count(): number {
    return this.first.length;
  }

  add(chunk: Chunk): void {
    for (let i = 0; i < chunk.count; ++i) {
      const [file, line] = [chunk.file[i], chunk.line[i]];
      if (file === this.lastFile && line === this.lastLine) continue;
      [this.lastFile, this.lastLine] = [file, line];
      const lines = this.byLine.get(file) ?? new Map<number, number[]>();
      this.byLine.set(file, lines);
      const blocks = lines.get(line) ?? [];
      lines.set(line, blocks);
      blocks.push(this.first.length);
      this.first.push(chunk.first + i);
    }
  }

  get(block: number): Block {
    const first = this.first.at(block);
    const next = this.end(block);
    const begin = this.segments.info(first);
    let length_mm = 0;
    for (let i = first; i < next; ++i) length_mm += this.segments.info(i).length_mm;
    return {
      file: begin.file,
      line: begin.line,
      first,
      count: next - first,
      start_s: begin.start_s,
      end_s: this.end_s(block),
      length_mm,
    };
  }

  /** The block of a segment. */
  of(segment: number): number {
    return lastIndex(this.count, (block) => this.first.at(block) <= segment);
  }

  /** The segment behind its last. */
  end(block: number): number {
    return block + 1 < this.count ? this.first.at(block + 1) : this.segments.count;
  }

  start_s(block: number): number {
    return this.segments.start_s(this.first.at(block));
  }

  end_s(block: number): number {
    const [chunk, i] = this.segments.locate(this.end(block) - 1);
    return chunk.start_s[i] + chunk.duration_s[i];
  }

  /** The blocks that come from a line, in the order of time. */
  ofLine(file: number, line: number): readonly number[] {
    return this.byLine.get(file)?.get(line) ?? [];
  }

  /** The block of a line that is under way at an instant, else the one whose start is nearest; -1: it moves nothing. */
  nearest(file: number, line: number, t_s: number): number {
    const blocks = this.ofLine(file, line);
    if (blocks.length === 0) return -1;
    const before = lastIndex(blocks.length, (i) => this.start_s(blocks[i]) <= t_s + SAME_TIME_S);
    const here = blocks[Math.max(before, 0)];
    if (before < 0 || before + 1 === blocks.length || this.end_s(here) >= t_s - SAME_TIME_S) return here;
    const next = blocks[before + 1];
    return this.start_s(next) - t_s < t_s - this.start_s(here) ? next : here;
  }
}

/** A typed array that grows. */
class Growing {
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

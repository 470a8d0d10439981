// The blocks of a run: segments one behind the other that come from the same line. A line that runs again, in a
// loop or a subprogram, is another block.

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
    const next = block + 1 < this.count ? this.first.at(block + 1) : this.segments.count;
    const begin = this.segments.info(first);
    const last = this.segments.info(next - 1);
    let length_mm = 0;
    for (let i = first; i < next; ++i) length_mm += this.segments.info(i).length_mm;
    return {
      file: begin.file,
      line: begin.line,
      first,
      count: next - first,
      start_s: begin.start_s,
      end_s: last.start_s + last.duration_s,
      length_mm,
    };
  }

  /** The block of a segment. */
  of(segment: number): number {
    let [low, high] = [0, this.count - 1];
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (this.first.at(middle) <= segment) low = middle;
      else high = middle - 1;
    }
    return low;
  }

  /** The blocks that come from a line, in the order of time. */
  ofLine(file: number, line: number): readonly number[] {
    return this.byLine.get(file)?.get(line) ?? [];
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

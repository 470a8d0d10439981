// Stretch of a run: up to 65,536 consecutive segments, with the data that is always loaded: the path of the
// TCP, its drawing data, and the source lines. All other data is in the columns of a chunk, which for a long
// run are fetched on demand (chunk_cache.ts).

import type { Message } from "../core/message";
import { lastIndex } from "./search";

/** All columns of the segments of a stretch (docs/studio.md). */
export interface Chunk {
  /** Number of its first segment. */
  first: number;
  count: number;
  start_s: Float64Array;
  duration_s: Float64Array;
  length_mm: Float64Array;
  feed_per_min: Float64Array;
  deviation_mm: Float64Array;
  line: Uint32Array;
  file: Uint32Array;
  flags: Uint32Array;
  tip: Uint32Array;
  record: Uint32Array;
  values: Float64Array;
}

export function readChunk(message: Message): Chunk {
  const column = <T>(name: string) => message.columns.get(name) as T;
  return {
    first: message.header.first as number,
    count: column<Float64Array>("start_s").length,
    start_s: column("start_s"),
    duration_s: column("duration_s"),
    length_mm: column("length_mm"),
    feed_per_min: column("feed_per_min"),
    deviation_mm: column("deviation_mm"),
    line: column("line"),
    file: column("file"),
    flags: column("flags"),
    tip: column("tip"),
    record: column("record"),
    values: column("values"),
  };
}

/** Line of a source, by the number of the source. */
export interface Line {
  file: number;
  line: number;
}

/**
 * Result of a search by vertices for an instant: a range of segments with the active one, from the first to
 * the last.
 */
export interface SegmentRange {
  from: number;
  to: number;
  /** Vertex at the end of the current part, if only one segment is possible; -1: several, or no path. */
  vertex: number;
}

/**
 * Row of `lines`: its first segment, and the file and line of that; each further segment is `step` lines on.
 */
const ROW_SIZE = 4;

// Decoding of an entry of vertex_segment, with its upper half (docs/studio-server.md).
const SEGMENT_MASK = 0xffff;
const SPEEDS_PER_OCTAVE = 8;
const CODE_OF_ONE_MM_PER_S = 17;
const speeds_mm_s = Float64Array.from({ length: 128 }, (_, code) =>
  code === 0 ? 0 : 2 ** ((code - CODE_OF_ONE_MM_PER_S) / SPEEDS_PER_OCTAVE),
);

export class RunSection {
  readonly count: number;
  readonly start_s: number;
  readonly end_s: number;
  readonly vertex_mm: Float32Array;
  /** How many vertices it has. */
  readonly vertices: number;
  /** Complete data of a permanently loaded stretch; null: fetched on demand. */
  readonly whole: Chunk | null;
  private readonly vertex_s: Float32Array;
  /** Origin of the vertex times. */
  private readonly base_s: number;
  private readonly packed: Uint32Array;
  private readonly lines: Uint32Array;

  /** `number`: number of earlier messages of segments; `before`: the stretch that this one continues. */
  constructor(
    readonly first: number,
    message: Message,
    readonly number: number,
    private readonly before: RunSection | undefined,
  ) {
    const { header, columns } = message;
    const column = <T>(name: string) => columns.get(name) as T;
    this.vertex_mm = column("vertex_mm");
    this.vertex_s = column("vertex_s");
    this.vertices = this.vertex_s.length;
    this.packed = column("vertex_segment");
    const whole = header.lean ? null : readChunk(message);
    const last = whole ? whole.count - 1 : 0;
    this.whole = whole;
    this.lines = header.lean ? column("lines") : new Uint32Array();
    this.count = whole?.count ?? (header.count as number);
    this.start_s = whole?.start_s[0] ?? (header.start_s as number | undefined) ?? before?.end_s ?? 0;
    this.base_s = whole ? 0 : this.start_s;
    this.end_s = whole && last >= 0 ? whole.start_s[last] + whole.duration_s[last] : ((header.end_s as number) ?? this.start_s);
  }

  /** Returns the segment that the part before a vertex belongs to. */
  vertexSegment(vertex: number): number {
    return this.first + (this.packed[vertex] & SEGMENT_MASK);
  }

  /**
   * Returns the flags of that segment (docs/studio.md); for a lean stretch its move, its limit without an
   * axis, and its process.
   */
  vertexFlags(vertex: number): number {
    const packed = this.packed[vertex];
    if (this.whole) return this.whole.flags[packed & SEGMENT_MASK];
    return (((packed >>> 16) & 0xff) << 8) | (((packed >>> 24) & 1) << 2);
  }

  /** Returns its mean speed along the path, mm/s; for a lean stretch within 5 %. */
  vertexSpeed_mm_s(vertex: number): number {
    const packed = this.packed[vertex];
    if (!this.whole) return speeds_mm_s[packed >>> 25];
    const segment = packed & SEGMENT_MASK;
    const duration_s = this.whole.duration_s[segment];
    return duration_s > 0 ? this.whole.length_mm[segment] / duration_s : 0;
  }

  time_s(vertex: number): number {
    return this.base_s + this.vertex_s[vertex];
  }

  /** Returns the vertex that ends the part active at a time; after the last, the number of vertices. */
  vertexAt(t_s: number): number {
    return lastIndex(this.vertices, (i) => this.time_s(i) <= t_s) + 1;
  }

  /**
   * Returns a range, because segments that wait have no vertices, so the start of the next part is unknown.
   */
  activeSegments(t_s: number): SegmentRange {
    const vertex = this.vertexAt(t_s);
    const last = this.first + this.count - 1;
    const from = (vertex > 0 ? this.vertexSegment(vertex - 1) : this.first - 1) + 1;
    if (vertex < this.vertices) {
      const to = this.vertexSegment(vertex);
      return from < to ? { from, to, vertex: -1 } : { from: to, to, vertex };
    }
    return from <= last ? { from, to: last, vertex: -1 } : { from: last, to: last, vertex: vertex - 1 };
  }

  /** Returns the first vertex at the end of this segment or a later one. */
  firstVertex(segment: number): number {
    const inside = segment - this.first;
    return lastIndex(this.packed.length, (i) => (this.packed[i] & SEGMENT_MASK) < inside) + 1;
  }

  /** Returns the approximate start of a segment: from vertices, in 32 bits. */
  approximateStart_s(segment: number): number {
    const vertex = this.firstVertex(segment);
    return segment > this.first && vertex > 0 ? this.time_s(vertex - 1) : this.start_s;
  }

  /**
   * Returns the TCP position at a time, interpolated between vertices (mm, in the work frame); null: none.
   */
  tip_mm(t_s: number): number[] | null {
    if (this.vertices === 0) return null;
    const to = Math.min(this.vertexAt(t_s), this.vertices - 1);
    const [b, b_s] = [this.vertex(to), this.time_s(to)];
    const a = to > 0 ? this.vertex(to - 1) : (this.before?.lastVertex ?? b);
    const a_s = to > 0 ? this.time_s(to - 1) : this.start_s;
    const share = b_s > a_s ? Math.min(Math.max((t_s - a_s) / (b_s - a_s), 0), 1) : 1;
    return a.map((value, i) => value + share * (b[i] - value));
  }

  private vertex(i: number): number[] {
    return Array.from(this.vertex_mm.subarray(3 * i, 3 * i + 3));
  }

  private get lastVertex(): number[] | null {
    return this.vertices > 0 ? this.vertex(this.vertices - 1) : (this.before?.lastVertex ?? null);
  }

  private get rows(): number {
    return this.lines.length / ROW_SIZE;
  }

  private rowOf(inside: number): number {
    return lastIndex(this.rows, (row) => this.lines[ROW_SIZE * row] <= inside);
  }

  private rowEnd(row: number): number {
    return row + 1 < this.rows ? this.lines[ROW_SIZE * (row + 1)] : this.count;
  }

  /** Returns the source line of a segment. */
  lineOf(segment: number): Line {
    const inside = segment - this.first;
    if (this.whole) return { file: this.whole.file[inside], line: this.whole.line[inside] };
    const at = ROW_SIZE * this.rowOf(inside);
    const { lines } = this;
    return { file: lines[at + 1], line: (lines[at + 2] + lines[at + 3] * (inside - lines[at])) >>> 0 };
  }

  private isOf({ file, line }: Line, segment: number): boolean {
    const own = this.lineOf(segment);
    return own.file === file && own.line === line;
  }

  /**
   * Returns the block of a segment in a lean stretch: its first segment with the same line, and the one after
   * its last.
   */
  blockAround(segment: number): [number, number] {
    const line = this.lineOf(segment);
    let row = this.rowOf(segment - this.first);
    const isConstantLine = (at: number) => this.lines[ROW_SIZE * at + 3] === 0 || this.rowEnd(at) - this.lines[ROW_SIZE * at] === 1;
    let [begin, end] = [segment, segment + 1];
    if (isConstantLine(row)) [begin, end] = [this.first + this.lines[ROW_SIZE * row], this.first + this.rowEnd(row)];
    const above = row;
    while (begin > this.first && this.isOf(line, begin - 1)) {
      row = this.rowOf(begin - 1 - this.first);
      begin = isConstantLine(row) ? this.first + this.lines[ROW_SIZE * row] : begin - 1;
    }
    row = above;
    while (end < this.first + this.count && this.isOf(line, end)) {
      row = this.rowOf(end - this.first);
      end = isConstantLine(row) ? this.first + this.rowEnd(row) : end + 1;
    }
    return [begin, end];
  }

  /**
   * Returns segments of a line in a lean stretch, in order: the start of each row, or one segment of a row.
   */
  *segmentsOf({ file, line }: Line): Generator<number> {
    const { lines } = this;
    for (let row = 0; row < this.rows; ++row) {
      const at = ROW_SIZE * row;
      if (lines[at + 1] !== file) continue;
      const count = this.rowEnd(row) - lines[at];
      const step = lines[at + 3] | 0;
      const away = line - lines[at + 2];
      const on = step === 0 ? 0 : away / step;
      if (step === 0 ? away !== 0 : !Number.isInteger(on) || on < 0 || on >= count) continue;
      yield this.first + lines[at] + on;
    }
  }
}

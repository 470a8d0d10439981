// A stretch of a run: up to 65,536 segments one behind the other, with what is always here of them: the way of the
// tip, what is drawn of it, and the lines that they come from. All else is in the columns of a chunk, which of a
// long run are fetched when they are looked at (laws.ts).

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

export function chunkOf(message: Message): Chunk {
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

/** A line of a source, by the number of that. */
export interface Line {
  file: number;
  line: number;
}

/** What a stretch tells by its vertices of an instant: segments of which one is under way, from the first to the last. */
export interface MaybeUnderWay {
  from: number;
  to: number;
  /** Where there is but one that it ends a piece of; -1: there are several, or it has no way. */
  vertex: number;
}

/** A row of `lines`: its first segment, and of that file and line; each further segment is `step` lines on. */
const ROW = 4;

// The upper half of an entry of vertex_segment (docs/studio-server.md).
const SEGMENT = 0xffff;
const SPEEDS_PER_OCTAVE = 8;
const ONE_MM_PER_S = 17;
const speeds_mm_s = Float64Array.from({ length: 128 }, (_, code) =>
  code === 0 ? 0 : 2 ** ((code - ONE_MM_PER_S) / SPEEDS_PER_OCTAVE),
);

export class Stretch {
  readonly count: number;
  readonly start_s: number;
  readonly end_s: number;
  readonly vertex_mm: Float32Array;
  /** How many vertices it has. */
  readonly vertices: number;
  /** All of it, of a stretch that is here for good; null: it is fetched. */
  readonly whole: Chunk | null;
  private readonly vertex_s: Float32Array;
  /** What times of vertices count from. */
  private readonly base_s: number;
  private readonly packed: Uint32Array;
  private readonly lines: Uint32Array;

  /** `number`: how many messages of segments the engine told before; `before`: the stretch that this one goes on from. */
  constructor(
    readonly first: number,
    message: Message,
    readonly number: number,
    private readonly before: Stretch | undefined,
  ) {
    const { header, columns } = message;
    const column = <T>(name: string) => columns.get(name) as T;
    this.vertex_mm = column("vertex_mm");
    this.vertex_s = column("vertex_s");
    this.vertices = this.vertex_s.length;
    this.packed = column("vertex_segment");
    const whole = header.lean ? null : chunkOf(message);
    const last = whole ? whole.count - 1 : 0;
    this.whole = whole;
    this.lines = header.lean ? column("lines") : new Uint32Array();
    this.count = whole?.count ?? (header.count as number);
    this.start_s = whole?.start_s[0] ?? (header.start_s as number | undefined) ?? before?.end_s ?? 0;
    this.base_s = whole ? 0 : this.start_s;
    this.end_s = whole && last >= 0 ? whole.start_s[last] + whole.duration_s[last] : ((header.end_s as number) ?? this.start_s);
  }

  /** Number of the segment whose way the piece before a vertex belongs to. */
  segmentOf(vertex: number): number {
    return this.first + (this.packed[vertex] & SEGMENT);
  }

  /** The flags of that segment (docs/studio.md); of a lean stretch its move, its limit without an axis, and its process. */
  flagsOf(vertex: number): number {
    const packed = this.packed[vertex];
    if (this.whole) return this.whole.flags[packed & SEGMENT];
    return (((packed >>> 16) & 0xff) << 8) | (((packed >>> 24) & 1) << 2);
  }

  /** Its mean speed along the path, mm/s; of a lean stretch within 5 %. */
  speedOf_mm_s(vertex: number): number {
    const packed = this.packed[vertex];
    if (!this.whole) return speeds_mm_s[packed >>> 25];
    const segment = packed & SEGMENT;
    const duration_s = this.whole.duration_s[segment];
    return duration_s > 0 ? this.whole.length_mm[segment] / duration_s : 0;
  }

  time_s(vertex: number): number {
    return this.base_s + this.vertex_s[vertex];
  }

  /** The vertex that ends the piece under way at a time; their number behind the last. */
  vertexAt(t_s: number): number {
    return lastIndex(this.vertices, (i) => this.time_s(i) <= t_s) + 1;
  }

  /** Segments that wait have no vertices, so that nothing tells when the next piece begins. */
  underWay(t_s: number): MaybeUnderWay {
    const vertex = this.vertexAt(t_s);
    const last = this.first + this.count - 1;
    const from = (vertex > 0 ? this.segmentOf(vertex - 1) : this.first - 1) + 1;
    if (vertex < this.vertices) {
      const to = this.segmentOf(vertex);
      return from < to ? { from, to, vertex: -1 } : { from: to, to, vertex };
    }
    return from <= last ? { from, to: last, vertex: -1 } : { from: last, to: last, vertex: vertex - 1 };
  }

  /** The first vertex that a segment from this one on ends at. */
  firstVertexOf(segment: number): number {
    const inside = segment - this.first;
    return lastIndex(this.packed.length, (i) => (this.packed[i] & SEGMENT) < inside) + 1;
  }

  /** About when a segment begins: by vertices, in 32 bits. */
  roughStart_s(segment: number): number {
    const vertex = this.firstVertexOf(segment);
    return segment > this.first && vertex > 0 ? this.time_s(vertex - 1) : this.start_s;
  }

  /** Where the tip is at a time, between the vertices about it (mm, in the work frame); null: nowhere. */
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
    return this.lines.length / ROW;
  }

  private rowOf(inside: number): number {
    return lastIndex(this.rows, (row) => this.lines[ROW * row] <= inside);
  }

  private endOfRow(row: number): number {
    return row + 1 < this.rows ? this.lines[ROW * (row + 1)] : this.count;
  }

  /** Where a segment comes from. */
  lineOf(segment: number): Line {
    const inside = segment - this.first;
    if (this.whole) return { file: this.whole.file[inside], line: this.whole.line[inside] };
    const at = ROW * this.rowOf(inside);
    const { lines } = this;
    return { file: lines[at + 1], line: (lines[at + 2] + lines[at + 3] * (inside - lines[at])) >>> 0 };
  }

  private isOf({ file, line }: Line, segment: number): boolean {
    const own = this.lineOf(segment);
    return own.file === file && own.line === line;
  }

  /** Of a lean stretch the first of the segments up to this one that come from its line, and the one behind the last. */
  blockAbout(segment: number): [number, number] {
    const line = this.lineOf(segment);
    let row = this.rowOf(segment - this.first);
    const isStill = (at: number) => this.lines[ROW * at + 3] === 0 || this.endOfRow(at) - this.lines[ROW * at] === 1;
    let [begin, end] = [segment, segment + 1];
    if (isStill(row)) [begin, end] = [this.first + this.lines[ROW * row], this.first + this.endOfRow(row)];
    const above = row;
    while (begin > this.first && this.isOf(line, begin - 1)) {
      row = this.rowOf(begin - 1 - this.first);
      begin = isStill(row) ? this.first + this.lines[ROW * row] : begin - 1;
    }
    row = above;
    while (end < this.first + this.count && this.isOf(line, end)) {
      row = this.rowOf(end - this.first);
      end = isStill(row) ? this.first + this.endOfRow(row) : end + 1;
    }
    return [begin, end];
  }

  /** Of a lean stretch segments of a line, in order: where rows of it begin, or one of a row. */
  *segmentsOf({ file, line }: Line): Generator<number> {
    const { lines } = this;
    for (let row = 0; row < this.rows; ++row) {
      const at = ROW * row;
      if (lines[at + 1] !== file) continue;
      const count = this.endOfRow(row) - lines[at];
      const step = lines[at + 3] | 0;
      const away = line - lines[at + 2];
      const on = step === 0 ? 0 : away / step;
      if (step === 0 ? away !== 0 : !Number.isInteger(on) || on < 0 || on >= count) continue;
      yield this.first + lines[at] + on;
    }
  }
}

// The segments of a run, as columns in chunks, in the order of time.

import type { Message } from "../core/message";
import { Flag, jointsAt, leadOf, pathSpeed, type JointState, type Part, type Records } from "./evaluate";
import { lawLength, newRange, widenByLaw } from "./law";
import { lastIndex } from "./search";

export const moveKinds = ["rapid", "linear", "arc_cw", "arc_ccw", "dwell", "probe", "thread", "spline"] as const;
export type MoveKind = (typeof moveKinds)[number];

export const limitKinds = [
  "feed",
  "path_speed",
  "joint_speed",
  "acceleration",
  "path_acceleration",
  "centripetal",
  "corner",
  "stop",
  "jerk",
  "look_ahead",
  "time",
  "rapid_override",
  "unknown",
] as const;
export type LimitKind = (typeof limitKinds)[number];

/** What the flags of a segment say (docs/studio.md): numbers of moveKinds and limitKinds, the limit's axis (-1: none). */
export const kindCodeOf = (flags: number): number => (flags >>> 8) & 15;
export const limitCodeOf = (flags: number): number => (flags >>> 12) & 15;
export const limitAxisOf = (flags: number): number => ((flags >>> 16) & 31) - 1;
export const isRapid = (flags: number): boolean => moveKinds[kindCodeOf(flags)] === "rapid";

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
  /** x, y, z of the tip on the part for each vertex of the drawn way, its time, its segment in the chunk. */
  vertex_mm: Float32Array;
  vertex_s: Float32Array;
  vertex_segment: Uint32Array;
}

/** A segment as rows have it. */
export interface SegmentInfo {
  index: number;
  start_s: number;
  duration_s: number;
  length_mm: number;
  /** As programmed, mm/min or deg/min; 0 in rapids and dwells. */
  feed_per_min: number;
  deviation_mm: number;
  line: number;
  file: number;
  tip: number;
  kind: MoveKind;
  rests: boolean;
  processOn: boolean;
  limit: LimitKind;
  /** The axis of the limit, as an index; -1: none. */
  limitAxis: number;
}

const RESTS = 3;

export class Segments {
  readonly chunks: Chunk[] = [];
  count = 0;

  constructor(readonly joints: number, readonly carriers: number[]) {}

  add(message: Message): void {
    const column = <T>(name: string) => message.columns.get(name) as T;
    const chunk: Chunk = {
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
      vertex_mm: column("vertex_mm"),
      vertex_s: column("vertex_s"),
      vertex_segment: column("vertex_segment"),
    };
    this.chunks.push(chunk);
    this.count = chunk.first + chunk.count;
  }

  get end_s(): number {
    const last = this.chunks.findLast((chunk) => chunk.count > 0);
    return last ? last.start_s[last.count - 1] + last.duration_s[last.count - 1] : 0;
  }

  /** The chunk of a segment, and its place there. */
  locate(index: number): [Chunk, number] {
    const { chunks } = this;
    const chunk = chunks[Math.max(lastIndex(chunks.length, (i) => chunks[i].first <= index), 0)];
    return [chunk, index - chunk.first];
  }

  /** The segment under way at a time: of two that meet there the later one; -1: there are none. */
  at(t_s: number): number {
    if (this.count === 0) return -1;
    return Math.max(lastIndex(this.count, (index) => this.start_s(index) <= t_s), 0);
  }

  start_s(index: number): number {
    const [chunk, i] = this.locate(index);
    return chunk.start_s[i];
  }

  info(index: number): SegmentInfo {
    const [chunk, i] = this.locate(index);
    const flags = chunk.flags[i];
    return {
      index,
      start_s: chunk.start_s[i],
      duration_s: chunk.duration_s[i],
      length_mm: chunk.length_mm[i],
      feed_per_min: chunk.feed_per_min[i],
      deviation_mm: chunk.deviation_mm[i],
      line: chunk.line[i],
      file: chunk.file[i],
      tip: chunk.tip[i],
      kind: moveKinds[kindCodeOf(flags)],
      rests: (flags & 3) === RESTS,
      processOn: (flags & Flag.processOn) !== 0,
      limit: limitKinds[limitCodeOf(flags)],
      limitAxis: limitAxisOf(flags),
    };
  }

  /** What a segment's state is evaluated from. */
  part(chunk: Chunk, i: number): Part {
    return { at: chunk.record[i], flags: chunk.flags[i], duration_s: chunk.duration_s[i] };
  }

  records(chunk: Chunk): Records {
    return { values: chunk.values, joints: this.joints };
  }

  /** Joints (mm, rad) at a time of the run. */
  joints_at(t_s: number): JointState | null {
    const index = this.at(t_s);
    if (index < 0) return null;
    const [chunk, i] = this.locate(index);
    return jointsAt(this.records(chunk), this.part(chunk, i), t_s - chunk.start_s[i]);
  }

  /** Speed of the tool along its path, mm/s; 0 where the run has ended. */
  speed_at(t_s: number): number {
    const index = this.at(t_s);
    if (index < 0 || t_s >= this.end_s) return 0;
    const [chunk, i] = this.locate(index);
    const since_s = t_s - chunk.start_s[i];
    return pathSpeed(this.records(chunk), this.part(chunk, i), since_s, chunk.length_mm[i], this.carriers);
  }

  /** The highest speed of a segment along the tool's path, mm/s. */
  peakSpeed(index: number): number {
    const [chunk, i] = this.locate(index);
    const law = leadOf(this.records(chunk), chunk.record[i]);
    const length = lawLength(chunk.values, law);
    if (!(length > 0)) return 0;
    const range = newRange();
    widenByLaw(chunk.values, law, range);
    return (range[1] * chunk.length_mm[i]) / length;
  }
}

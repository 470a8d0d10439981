// The segments of a run, as columns in chunks, in the order of time.

import type { Message } from "../core/message";
import { jointsAt, leadOf, pathSpeed, type JointState, type Part, type Records } from "./evaluate";
import { Flag, limitKinds, moveKinds, segmentKinds, type LimitKind, type MoveKind } from "./kinds";
import { lawLength, newRange, widenByLaw } from "./law";
import type { Laws } from "./laws";
import { lastIndex } from "./search";
import { Stretch, type Chunk, type Line, type MaybeUnderWay } from "./stretch";

/** What the flags of a segment say (docs/studio.md): numbers of moveKinds and limitKinds, the limit's axis (-1: none). */
export const kindCodeOf = (flags: number): number => (flags >>> 8) & 15;
export const limitCodeOf = (flags: number): number => (flags >>> 12) & 15;
export const limitAxisOf = (flags: number): number => ((flags >>> 16) & 31) - 1;
const REST = segmentKinds.indexOf("rest");
/** Whether nothing moves, also within a move: a control may wait for its axes to settle. */
export const isRest = (flags: number): boolean => (flags & 3) === REST;
export const isRapid = (flags: number): boolean => moveKinds[kindCodeOf(flags)] === "rapid";

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

/** Segments of which one is under way, from the first to the last: by a chunk it is one. */
interface UnderWay extends MaybeUnderWay {
  stretch: Stretch;
  chunk: Chunk | null;
}

/**
 * Of a long run what a segment's state is evaluated from is not here until it is fetched: what needs it is null then,
 * and what is told by vertices is so within 32 bits.
 */
export class Segments {
  /** All, in the order of time. */
  readonly stretches: Stretch[] = [];
  /** Of those that are here for good, which come first. */
  readonly chunks: Chunk[] = [];
  count = 0;

  constructor(
    readonly joints: number,
    readonly carriers: number[],
    private readonly laws: Laws | null = null,
  ) {}

  /** `number`: how many messages of segments the engine told before. */
  add(message: Message, number = this.stretches.length): void {
    const stretch = new Stretch(message.header.first as number, message, number, this.stretches.at(-1));
    if (stretch.count === 0 && stretch.vertices === 0) return;
    this.stretches.push(stretch);
    if (stretch.whole) this.chunks.push(stretch.whole);
    this.count = stretch.first + stretch.count;
  }

  /** Whether there is more than what is here for good. */
  get isLong(): boolean {
    return this.chunks.length < this.stretches.length;
  }

  get end_s(): number {
    return this.stretches.at(-1)?.end_s ?? 0;
  }

  /** The stretch of a segment. */
  stretchOf(index: number): Stretch {
    const { stretches } = this;
    return stretches[Math.max(lastIndex(stretches.length, (i) => stretches[i].first <= index), 0)];
  }

  /** The stretch under way at a time; undefined: nothing moves. */
  stretchAt(t_s: number): Stretch | undefined {
    const { stretches } = this;
    if (this.count === 0) return undefined;
    return stretches[Math.max(lastIndex(stretches.length, (i) => stretches[i].start_s <= t_s), 0)];
  }

  private chunk(stretch: Stretch): Chunk | null {
    return stretch.whole ?? this.laws?.get(stretch) ?? null;
  }

  /** The chunk of a segment, and its place there; null: it is not here. */
  locate(index: number): [Chunk, number] | null {
    const stretch = this.stretchOf(index);
    const chunk = this.chunk(stretch);
    return chunk && [chunk, index - stretch.first];
  }

  /** The stretch under way at a time where it is not here. */
  lacking(t_s: number): Stretch | null {
    const stretch = this.stretchAt(t_s);
    return stretch && !this.chunk(stretch) ? stretch : null;
  }

  /** Fetches all of a segment; whether it is here then. */
  async need(index: number): Promise<boolean> {
    const stretch = this.stretchOf(index);
    return stretch.whole !== null || ((await this.laws?.need(stretch)) ?? false);
  }

  /** What is under way at a time: of two that meet there the later one; undefined: nothing moves. */
  private underWay(t_s: number): UnderWay | undefined {
    const stretch = this.stretchAt(t_s);
    if (!stretch) return undefined;
    const chunk = this.chunk(stretch);
    if (!chunk) return { stretch, chunk, ...stretch.underWay(t_s) };
    const index = chunk.first + Math.max(lastIndex(chunk.count, (i) => chunk.start_s[i] <= t_s), 0);
    return { stretch, chunk, from: index, to: index, vertex: -1 };
  }

  /** The segment under way at a time; -1: there are none. Where it is not here, and may wait, the one behind that. */
  at(t_s: number): number {
    return this.underWay(t_s)?.to ?? -1;
  }

  /** The flags of the segment under way, as far as they are here (Stretch.flagsOf); null: there is none, or it is not known. */
  flags_at(t_s: number): number | null {
    const now = this.underWay(t_s);
    if (!now || t_s > now.stretch.end_s) return null;
    const { stretch, chunk, vertex } = now;
    if (!chunk) return vertex < 0 ? null : stretch.flagsOf(vertex);
    const i = now.to - chunk.first;
    return t_s > chunk.start_s[i] + chunk.duration_s[i] ? null : chunk.flags[i];
  }

  /** Where the segment under way comes from; null: there is none, or it is not known. */
  lineAt(t_s: number): Line | null {
    const now = this.underWay(t_s);
    if (!now) return null;
    const [line, last] = [this.lineOf(now.from), this.lineOf(now.to)];
    return line.file === last.file && line.line === last.line ? line : null;
  }

  /** Where the tip is at a time by the drawn way (mm, in the work frame); null: nothing moves. */
  tip_mm(t_s: number): number[] | null {
    return this.stretchAt(t_s)?.tip_mm(t_s) ?? null;
  }

  /** When a segment begins; by vertices where it is not here. */
  start_s(index: number): number {
    const stretch = this.stretchOf(index);
    const chunk = this.chunk(stretch);
    return chunk ? chunk.start_s[index - stretch.first] : stretch.roughStart_s(index);
  }

  /** When it ends, as start_s(). */
  end_s_of(index: number): number {
    const here = this.locate(index);
    if (here) return here[0].start_s[here[1]] + here[0].duration_s[here[1]];
    const stretch = this.stretchOf(index);
    return index + 1 < stretch.first + stretch.count ? stretch.roughStart_s(index + 1) : stretch.end_s;
  }

  lineOf(index: number): Line {
    return this.stretchOf(index).lineOf(index);
  }

  info(index: number): SegmentInfo | null {
    const here = this.locate(index);
    if (!here) return null;
    const [chunk, i] = here;
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
      rests: isRest(flags),
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

  /** Joints (mm, rad) at a time of the run; null: there are none, or they are not here. */
  joints_at(t_s: number): JointState | null {
    const here = this.hereAt(t_s);
    if (!here) return null;
    const [chunk, i] = here;
    return jointsAt(this.records(chunk), this.part(chunk, i), t_s - chunk.start_s[i]);
  }

  private hereAt(t_s: number): [Chunk, number] | null {
    const index = this.at(t_s);
    return index < 0 ? null : this.locate(index);
  }

  /** Speed of the tool along its path, mm/s; 0 where the run has ended; null: it is not here. */
  speed_at(t_s: number): number | null {
    if (this.count === 0 || t_s >= this.end_s) return 0;
    const here = this.hereAt(t_s);
    if (!here) return null;
    const [chunk, i] = here;
    const since_s = t_s - chunk.start_s[i];
    return pathSpeed(this.records(chunk), this.part(chunk, i), since_s, chunk.length_mm[i], this.carriers);
  }

  /** The highest speed of a segment along the tool's path, mm/s. */
  peakSpeed(chunk: Chunk, i: number): number {
    const law = leadOf(this.records(chunk), chunk.record[i]);
    const length = lawLength(chunk.values, law);
    if (!(length > 0)) return 0;
    const range = newRange();
    widenByLaw(chunk.values, law, range);
    return (range[1] * chunk.length_mm[i]) / length;
  }
}

// Segments of a run, as columns in chunks, in the order of time.

import type { Message } from "../core/message";
import { jointsAt, pathLawOffset, pathSpeed, type JointState, type SegmentRecord, type Records } from "./evaluate";
import { Flag, limitKinds, moveKinds, segmentKinds, type LimitKind, type MoveKind } from "./kinds";
import { lawLength, newRange, extendByLaw } from "./time_law";
import type { ChunkCache } from "./chunk_cache";
import { lastIndex } from "./search";
import { RunSection, type Chunk, type Line, type SegmentRange } from "./run_section";

/**
 * Decodes the flags of a segment (docs/studio.md): numbers of moveKinds and limitKinds, the limit's axis (-1:
 * none).
 */
export const decodeKind = (flags: number): number => (flags >>> 8) & 15;
export const decodeLimit = (flags: number): number => (flags >>> 12) & 15;
export const decodeLimitAxis = (flags: number): number => ((flags >>> 16) & 31) - 1;
const STANDSTILL = segmentKinds.indexOf("rest");
/** True if nothing moves, also within a move: a controller may wait for its axes to settle. */
export const isStandstill = (flags: number): boolean => (flags & 3) === STANDSTILL;
export const isRapid = (flags: number): boolean => moveKinds[decodeKind(flags)] === "rapid";

/** Segment as used by rows. */
export interface SegmentInfo {
  index: number;
  start_s: number;
  duration_s: number;
  length_mm: number;
  /** Programmed feed, mm/min or deg/min; 0 in rapids and dwells. */
  feed_per_min: number;
  deviation_mm: number;
  line: number;
  file: number;
  tip: number;
  kind: MoveKind;
  isStationary: boolean;
  processOn: boolean;
  limit: LimitKind;
  /** Axis of the limit, as an index; -1: none. */
  limitAxis: number;
}

/** Range of segments with the active one, from the first to the last; a single one if the chunk is loaded. */
interface ActiveSegments extends SegmentRange {
  section: RunSection;
  chunk: Chunk | null;
}

/**
 * For a long run the data of a segment's state is fetched on demand: functions that need it return null until
 * then, and values from vertices have 32 bits.
 */
export class Segments {
  /** All stretches, in the order of time. */
  readonly sections: RunSection[] = [];
  /** Chunks of the permanently loaded stretches, which come first. */
  readonly chunks: Chunk[] = [];
  count = 0;

  constructor(
    readonly joints: number,
    readonly positionJoints: number[],
    private readonly laws: ChunkCache | null = null,
  ) {}

  /** `number`: number of earlier messages of segments. */
  add(message: Message, number = this.sections.length): void {
    const section = new RunSection(message.header.first as number, message, number, this.sections.at(-1));
    if (section.count === 0 && section.vertices === 0) return;
    this.sections.push(section);
    if (section.whole) this.chunks.push(section.whole);
    this.count = section.first + section.count;
  }

  /** True if some segments are not permanently loaded. */
  get isLong(): boolean {
    return this.chunks.length < this.sections.length;
  }

  get end_s(): number {
    return this.sections.at(-1)?.end_s ?? 0;
  }

  /** The stretch of a segment. */
  sectionOf(index: number): RunSection {
    const { sections } = this;
    return sections[Math.max(lastIndex(sections.length, (i) => sections[i].first <= index), 0)];
  }

  /** Returns the stretch active at a time; undefined: nothing moves. */
  sectionAt(t_s: number): RunSection | undefined {
    const { sections } = this;
    if (this.count === 0) return undefined;
    return sections[Math.max(lastIndex(sections.length, (i) => sections[i].start_s <= t_s), 0)];
  }

  private chunk(section: RunSection): Chunk | null {
    return section.whole ?? this.laws?.get(section) ?? null;
  }

  /** Returns the chunk of a segment, and its index there; null: not loaded. */
  locate(index: number): [Chunk, number] | null {
    const section = this.sectionOf(index);
    const chunk = this.chunk(section);
    return chunk && [chunk, index - section.first];
  }

  /** Returns the stretch active at a time if it is not loaded. */
  missingSection(t_s: number): RunSection | null {
    const section = this.sectionAt(t_s);
    return section && !this.chunk(section) ? section : null;
  }

  /** Fetches all data of a segment; returns true if it is then loaded. */
  async fetchNow(index: number): Promise<boolean> {
    const section = this.sectionOf(index);
    return section.whole !== null || ((await this.laws?.fetchNow(section)) ?? false);
  }

  /**
   * Returns the segments active at a time: of two that meet there the later one; undefined: nothing moves.
   */
  private activeSegments(t_s: number): ActiveSegments | undefined {
    const section = this.sectionAt(t_s);
    if (!section) return undefined;
    const chunk = this.chunk(section);
    if (!chunk) return { section, chunk, ...section.activeSegments(t_s) };
    const index = chunk.first + Math.max(lastIndex(chunk.count, (i) => chunk.start_s[i] <= t_s), 0);
    return { section, chunk, from: index, to: index, vertex: -1 };
  }

  /**
   * Returns the segment active at a time; -1: none. If it is not loaded, and may be a wait, the one after
   * that.
   */
  at(t_s: number): number {
    return this.activeSegments(t_s)?.to ?? -1;
  }

  /**
   * Returns the flags of the active segment, as far as loaded (RunSection.vertexFlags); null: none, or not known.
   */
  flagsAt(t_s: number): number | null {
    const now = this.activeSegments(t_s);
    if (!now || t_s > now.section.end_s) return null;
    const { section, chunk, vertex } = now;
    if (!chunk) return vertex < 0 ? null : section.vertexFlags(vertex);
    const i = now.to - chunk.first;
    return t_s > chunk.start_s[i] + chunk.duration_s[i] ? null : chunk.flags[i];
  }

  /** Returns the source line of the active segment; null: none, or not known. */
  lineAt(t_s: number): Line | null {
    const now = this.activeSegments(t_s);
    if (!now) return null;
    const [line, last] = [this.lineOf(now.from), this.lineOf(now.to)];
    return line.file === last.file && line.line === last.line ? line : null;
  }

  /** Returns the TCP position at a time on the drawn path (mm, in the work frame); null: nothing moves. */
  tip_mm(t_s: number): number[] | null {
    return this.sectionAt(t_s)?.tip_mm(t_s) ?? null;
  }

  /** Returns the start of a segment; from vertices if it is not loaded. */
  start_s(index: number): number {
    const section = this.sectionOf(index);
    const chunk = this.chunk(section);
    return chunk ? chunk.start_s[index - section.first] : section.approximateStart_s(index);
  }

  /** Returns the end of a segment, as start_s(). */
  segmentEnd_s(index: number): number {
    const here = this.locate(index);
    if (here) return here[0].start_s[here[1]] + here[0].duration_s[here[1]];
    const section = this.sectionOf(index);
    return index + 1 < section.first + section.count ? section.approximateStart_s(index + 1) : section.end_s;
  }

  lineOf(index: number): Line {
    return this.sectionOf(index).lineOf(index);
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
      kind: moveKinds[decodeKind(flags)],
      isStationary: isStandstill(flags),
      processOn: (flags & Flag.processOn) !== 0,
      limit: limitKinds[decodeLimit(flags)],
      limitAxis: decodeLimitAxis(flags),
    };
  }

  /** Returns the data for a segment's state. */
  part(chunk: Chunk, i: number): SegmentRecord {
    return { at: chunk.record[i], flags: chunk.flags[i], duration_s: chunk.duration_s[i] };
  }

  records(chunk: Chunk): Records {
    return { values: chunk.values, joints: this.joints };
  }

  /** Returns joints (mm, rad) at a time of the run; null: none, or not loaded. */
  joints_at(t_s: number): JointState | null {
    const here = this.locateAt(t_s);
    if (!here) return null;
    const [chunk, i] = here;
    return jointsAt(this.records(chunk), this.part(chunk, i), t_s - chunk.start_s[i]);
  }

  private locateAt(t_s: number): [Chunk, number] | null {
    const index = this.at(t_s);
    return index < 0 ? null : this.locate(index);
  }

  /** Returns the speed of the tool along its path, mm/s; 0 after the end of the run; null: not loaded. */
  speed_at(t_s: number): number | null {
    if (this.count === 0 || t_s >= this.end_s) return 0;
    const here = this.locateAt(t_s);
    if (!here) return null;
    const [chunk, i] = here;
    const since_s = t_s - chunk.start_s[i];
    return pathSpeed(this.records(chunk), this.part(chunk, i), since_s, chunk.length_mm[i], this.positionJoints);
  }

  /** Returns the highest speed of a segment along the tool's path, mm/s. */
  peakSpeed(chunk: Chunk, i: number): number {
    const law = pathLawOffset(this.records(chunk), chunk.record[i]);
    const length = lawLength(chunk.values, law);
    if (!(length > 0)) return 0;
    const range = newRange();
    extendByLaw(chunk.values, law, range);
    return (range[1] * chunk.length_mm[i]) / length;
  }
}

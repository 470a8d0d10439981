// Exact chart values of a segment, from its closed forms.

import { lawBreaks_s, isProportional, jointsAt, pathLawOffset, pathAcceleration, pathSpeed } from "../../run/evaluate";
import type { SegmentRecord } from "../../run/evaluate";
import { Flag } from "../../run/kinds";
import { lawLength, newRange, extendByLaw } from "../../run/time_law";
import { isRapid, type Segments } from "../../run/segments";
import type { Chunk } from "../../run/run_section";

/**
 * Values that are evaluated together: for the path its speed, acceleration and programmed feed; else one
 * value for each joint.
 */
export type Group = "path" | "position" | "speed" | "acceleration";
export const PATH = { speed: 0, acceleration: 1, feed: 2 } as const;

const EMPTY_RANGE = newRange();
const CURVED_SAMPLES = 8;
// A law has two accelerations at the boundary of its parts: one before, and one after.
export const AFTER_S = 1e-9;

/** One segment, and its index in its chunk. */
export interface SegmentRef {
  chunk: Chunk;
  i: number;
  part: SegmentRecord;
}

export class CurveSampler {
  private readonly law = newRange();
  private readonly point: Float64Array;
  readonly width: number;

  constructor(
    private readonly segments: Segments,
    readonly group: Group,
  ) {
    this.width = group === "path" ? 3 : segments.joints;
    this.point = new Float64Array(this.width);
  }

  /** Null: it is not here. */
  segmentRef(index: number): SegmentRef | null {
    const here = this.segments.locate(index);
    return here && { chunk: here[0], i: here[1], part: this.segments.part(...here) };
  }

  /** Sets the values `t_s` after the segment's start, in mm or rad and s; NaN: no programmed feed. */
  put({ chunk, i, part }: SegmentRef, t_s: number, out: Float64Array): void {
    const records = this.segments.records(chunk);
    if (this.group === "path") {
      const { positionJoints } = this.segments;
      out[PATH.speed] = pathSpeed(records, part, t_s, chunk.length_mm[i], positionJoints);
      out[PATH.acceleration] = pathAcceleration(records, part, t_s, chunk.length_mm[i], positionJoints);
      out[PATH.feed] = programmedFeed(chunk, i);
      return;
    }
    const state = jointsAt(records, part, t_s);
    const { group } = this;
    out.set(group === "position" ? state.position : group === "speed" ? state.velocity : state.acceleration);
  }

  /** Returns the instants of a segment at which a value may jump or have its maximum, in order. */
  breaks_s({ chunk, part }: SegmentRef): number[] {
    return lawBreaks_s(this.segments.records(chunk), part)
      .filter((t_s) => t_s > 0 && t_s < part.duration_s)
      .sort((a, b) => a - b);
  }

  /** Widens `low` and `high` by all values of a segment. */
  expand(segmentRef: SegmentRef, low: Float32Array, high: Float32Array, at: number): void {
    const { chunk, part } = segmentRef;
    if (this.group === "path" && !(part.flags & NOT_PROPORTIONAL)) return this.widenPath(segmentRef, low, high, at);
    if (this.group !== "path" && isProportional(this.segments.records(chunk), part)) {
      return this.widenProportional(segmentRef, low, high, at);
    }
    this.widenWithin(segmentRef, 0, part.duration_s, low, high, at);
  }

  /** Widens by part of a segment, from samples; exact at changes of laws. */
  widenWithin(segmentRef: SegmentRef, from_s: number, to_s: number, low: Float32Array, high: Float32Array, at: number): void {
    const addSample = (t_s: number) => {
      this.put(segmentRef, t_s, this.point);
      for (let j = 0; j < this.width; ++j) expand(low, high, at + j, this.point[j]);
    };
    for (const t_s of this.breaks_s(segmentRef)) {
      if (t_s <= from_s || t_s >= to_s) continue;
      addSample(t_s);
      addSample(t_s + AFTER_S);
    }
    const samples = isProportional(this.segments.records(segmentRef.chunk), segmentRef.part) ? 1 : CURVED_SAMPLES;
    for (let i = 0; i <= samples; ++i) addSample(from_s + ((to_s - from_s) * i) / samples);
  }

  private readLaw(chunk: Chunk, part: SegmentRecord): number {
    const lead = pathLawOffset(this.segments.records(chunk), part.at);
    this.law.set(EMPTY_RANGE);
    extendByLaw(chunk.values, lead, this.law);
    return lawLength(chunk.values, lead);
  }

  private widenPath({ chunk, i, part }: SegmentRef, low: Float32Array, high: Float32Array, at: number): void {
    const length = this.readLaw(chunk, part);
    const scale = length > 0 ? chunk.length_mm[i] / length : 0;
    this.widenBoth(low, high, at + PATH.speed, 0, scale);
    this.widenBoth(low, high, at + PATH.acceleration, 2, scale);
    expand(low, high, at + PATH.feed, programmedFeed(chunk, i));
  }

  private widenProportional({ chunk, part }: SegmentRef, low: Float32Array, high: Float32Array, at: number): void {
    const length = this.group === "position" ? 0 : this.readLaw(chunk, part);
    for (let j = 0; j < this.width; ++j) {
      const from = chunk.values[part.at + j];
      const to = chunk.values[part.at + this.width + j];
      if (this.group === "position") {
        expand(low, high, at + j, from);
        expand(low, high, at + j, to);
      } else {
        this.widenBoth(low, high, at + j, this.group === "speed" ? 0 : 2, length > 0 ? (to - from) / length : 0);
      }
    }
  }

  // A factor of 0 is a joint at standstill, whatever the law.
  private widenBoth(low: Float32Array, high: Float32Array, at: number, law: number, factor: number): void {
    for (let side = law; side < law + 2; ++side) {
      const value = this.law[side];
      expand(low, high, at, factor === 0 || !Number.isFinite(value) ? 0 : value * factor);
    }
  }
}

/** With these flags the speed along the path is not that of the leading law alone. */
const NOT_PROPORTIONAL = Flag.beside | Flag.apart;

function programmedFeed(chunk: Chunk, i: number): number {
  const feed = chunk.feed_per_min[i];
  return feed > 0 && !isRapid(chunk.flags[i]) && chunk.length_mm[i] > 0 ? feed / 60 : NaN;
}

function expand(low: Float32Array, high: Float32Array, at: number, value: number): void {
  if (value < low[at]) low[at] = value;
  if (value > high[at]) high[at] = value;
}

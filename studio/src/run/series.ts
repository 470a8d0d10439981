// Values of a run over time in addition to its segments (forces, following errors): straight lines between
// instants, or for long runs the lowest and highest values within steps of time.

import type { Message } from "../core/message";
import { lastIndex } from "./search";

export const seriesKinds = ["efforts", "following"] as const;
export type SeriesKind = (typeof seriesKinds)[number];

/** One curve. Efforts are in N and Nm, shares relative to the motor's capability, errors in mm and deg. */
export interface Channel {
  of: "power" | "effort" | "motor_peak" | "share" | "contour" | "error";
  /** Number of the axis; missing for the complete machine. */
  axis?: number;
}

/** Rounding margin (s) at both ends; no values exist beyond it. */
const END_TOLERANCE_S = 1e-6;

export class Series {
  readonly channels: Channel[];
  /** Length of steps, s; 0: instants. */
  readonly step_s: number;
  private readonly t_s: Float64Array;
  /** Values of all channels, instant by instant or step by step; equal to `high` for instants. */
  private readonly low: Float32Array;
  private readonly high: Float32Array;

  constructor({ header, columns }: Message) {
    this.channels = header.channels as Channel[];
    this.step_s = header.step_s as number;
    this.t_s = (columns.get("t_s") ?? new Float64Array()) as Float64Array;
    this.low = (columns.get("low") ?? columns.get("values")) as Float32Array;
    this.high = (columns.get("high") ?? columns.get("values")) as Float32Array;
  }

  /** How many curves there are. */
  get width(): number {
    return this.channels.length;
  }

  /** Instants, or steps. */
  get count(): number {
    return this.low.length / this.width;
  }

  /** Returns the number of a curve; -1: none. */
  channel(of: Channel["of"], axis?: number): number {
    return this.channels.findIndex((channel) => channel.of === of && channel.axis === axis);
  }

  /** Returns the last instant up to a time (-1: before all), or the step at it, which need not exist. */
  indexAt(t_s: number): number {
    if (this.step_s > 0) return Math.floor(t_s / this.step_s);
    return lastIndex(this.t_s.length, (i) => this.t_s[i] <= t_s);
  }

  /** Returns the time of an instant, or of the start of a step. */
  time_s(index: number): number {
    return this.step_s > 0 ? index * this.step_s : this.t_s[index];
  }

  /** The values of an instant. */
  row(index: number): Float32Array {
    return this.low.subarray(index * this.width, (index + 1) * this.width);
  }

  /** Widens the range by the values of an instant or a step. */
  expand(index: number, low: Float32Array, high: Float32Array): void {
    const at = index * this.width;
    for (let j = 0; j < this.width; ++j) {
      if (this.low[at + j] < low[j]) low[j] = this.low[at + j];
      if (this.high[at + j] > high[j]) high[j] = this.high[at + j];
    }
  }

  /** Sets the values at a time, NaN if none; for a step those that are farthest from 0. */
  put(t_s: number, out: Float32Array): void {
    const { width, count } = this;
    const index = this.indexAt(t_s);
    if (this.step_s > 0) return this.putFarthest(index, out);
    const isOutside = count === 0 || t_s < this.t_s[0] - END_TOLERANCE_S || t_s > this.t_s[count - 1] + END_TOLERANCE_S;
    const before = Math.max(index, 0) * width;
    const after = Math.min(index + 1, count - 1) * width;
    const [from_s, to_s] = [this.t_s[before / width], this.t_s[after / width]];
    const share = to_s > from_s ? (t_s - from_s) / (to_s - from_s) : 0;
    for (let j = 0; j < width; ++j) {
      const value = this.low[before + j];
      out[j] = isOutside ? NaN : value + (share > 0 ? share * (this.low[after + j] - value) : 0);
    }
  }

  private putFarthest(step: number, out: Float32Array): void {
    for (let j = 0; j < this.width; ++j) {
      const [low, high] = [this.low[step * this.width + j], this.high[step * this.width + j]];
      out[j] = -low > high ? low : high;
    }
  }
}

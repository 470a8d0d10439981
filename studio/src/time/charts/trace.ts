// One curve of a chart, and the options for all.

import type { Units } from "../../core/store";
import type { Limit } from "./limit_lines";

/** Scales; values with the same unit share one. */
export type ScaleId = "mm" | "deg" | "percent" | "force" | "torque" | "power";

export interface Trace {
  name: string;
  channel: number;
  colour: string;
  dashed: boolean;
  scale: ScaleId;
  unit: string;
  /** The shown value is `offset` plus `factor` times that of the segments (mm or rad, s). */
  factor: number;
  offset: number;
  /** Whether the scale always shows 0. */
  fromZero: boolean;
  /** True if it is a limit for the others, which is not shown if it is far beyond them. */
  isLimit?: boolean;
  limits: Limit[];
}

export interface Choice {
  units: Units;
  /** Axes by index. */
  axes: ReadonlySet<number>;
  /** Speeds, accelerations and efforts as a share of the axis's limit. */
  percent: boolean;
}

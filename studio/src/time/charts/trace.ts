// One curve of a chart, and what is chosen of all.

import type { Units } from "../../core/store";
import type { Limit } from "./limit_lines";

/** Values that share a unit share a scale. */
export type ScaleId = "mm" | "deg" | "percent" | "force" | "torque" | "power";

export interface Trace {
  name: string;
  channel: number;
  colour: string;
  dashed: boolean;
  scale: ScaleId;
  unit: string;
  /** Shown is `offset` and `factor` times what the segments have (mm or rad, s). */
  factor: number;
  offset: number;
  /** Whether the scale always shows 0. */
  fromZero: boolean;
  /** Whether it is a limit that others are held against, which is out of sight where it is far beyond them. */
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

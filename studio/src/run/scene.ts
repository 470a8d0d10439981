// Contents of a run's world, as sent by the engine (docs/studio.md).

export type Matrix = number[]; // 16 values, column by column
export type Point = [number, number, number];

export interface Axis {
  letter: string;
  rotary: boolean;
  /** Limits in mm or deg, s; null: none. */
  min: number | null;
  max: number | null;
  max_speed: number | null;
  max_acceleration: number | null;
  max_jerk: number | null;
  /** Max effort of its motor, N or Nm; null: not known. */
  motor_peak: number | null;
  /** True if the motor is weaker at some speeds. */
  motor_fades: boolean;
  home: number;
  /** Reading of the axis at joint value 0. */
  zero: number;
  carries: "tool" | "work" | "nothing";
}

export interface Link {
  joint: number;
  rotary: boolean;
  before: Matrix;
  after: Matrix;
}

export interface Branch {
  base: Matrix;
  links: Link[];
  end: Matrix;
}

export type Shape =
  | { kind: "box"; half_mm: Point; margin_mm: number }
  | { kind: "cylinder"; radius_mm: number; half_height_mm: number; margin_mm: number }
  | { kind: "points"; points_mm: Point[]; margin_mm: number }
  | { kind: "mesh"; mesh: number };

export interface Body {
  name: string;
  role: "machine" | "jet" | "workpiece" | "fixture";
  frame: number;
  shape: Shape;
}

/**
 * Frame of the machine: with a link (0 the world, i the one that joint i - 1 moves). Else attached to another
 * frame.
 */
export type Frame =
  | { name: string; link: number; in_link: Matrix }
  | { name: string; parent: number; in_parent: Matrix };

/** Motion of a frame in its parent from `from_s` on, until its next drift. */
export interface UniformMotion {
  frame: number;
  from_s: number;
  pose: Matrix;
  velocity_mm_s: Point;
  spin_rad_s: Point;
}

/** Box in machine coordinates; null: no wall there. */
export interface Zone {
  name: string;
  /** True if the tool stays inside, else outside. */
  inside: boolean;
  on: boolean;
  min_mm: (number | null)[];
  max_mm: (number | null)[];
}

export interface Scene {
  machine: string;
  controller: string;
  /** Machine's world in that of all robots. */
  base: Matrix;
  axes: Axis[];
  position_joints: [number, number, number];
  tool_side: Branch;
  work_side: Branch;
  /** Transformation from X, Y and Z of the machine to the work frame, other axes at 0. */
  axis_space: Matrix | null;
  max_feed_mm_s: number | null;
  max_rapid_mm_s: number | null;
  max_acceleration_mm_s2: number | null;
  process: string | null;
  zones: Zone[];
  /** TCPs of the tools used, in the frame of the tool centre point (without tool offset). */
  tcps_mm: Point[];
  cell?: string;
  clearance_mm?: number;
  frames?: Frame[];
  bodies?: Body[];
  drifts?: UniformMotion[];
  /** Times of the report's clearances. */
  near_s?: (number | null)[];
}

// What stands in a run's world, as the engine tells it (docs/studio.md).

export type Matrix = number[]; // 16 values, columns one behind the other
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
  /** The most that its motor brings up, N or Nm; null: it is not told. */
  motor_peak: number | null;
  /** Whether it brings up less at some speeds. */
  motor_fades: boolean;
  home: number;
  /** Reading of the axis where its joint is at 0. */
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

/** Of the machine: with a link (0 the world, i what joint i - 1 moves). Else attached to another frame. */
export type Frame =
  | { name: string; link: number; in_link: Matrix }
  | { name: string; parent: number; in_parent: Matrix };

/** From `from_s` on a frame goes so in the one that it is attached to, until its next drift. */
export interface Drift {
  frame: number;
  from_s: number;
  pose: Matrix;
  velocity_mm_s: Point;
  spin_rad_s: Point;
}

/** A box in machine coordinates; null: no wall there. */
export interface Zone {
  name: string;
  /** The tool stays inside, else outside. */
  inside: boolean;
  on: boolean;
  min_mm: (number | null)[];
  max_mm: (number | null)[];
}

export interface Scene {
  machine: string;
  controller: string;
  /** Of the machine's world in that of all robots. */
  base: Matrix;
  axes: Axis[];
  position_joints: [number, number, number];
  tool_side: Branch;
  work_side: Branch;
  /** From X, Y and Z of the machine to the work frame, other axes at 0. */
  axis_space: Matrix | null;
  max_feed_mm_s: number | null;
  max_rapid_mm_s: number | null;
  max_acceleration_mm_s2: number | null;
  process: string | null;
  zones: Zone[];
  /** Tips of the tools used, in the frame of the tool centre point. */
  tips_mm: Point[];
  cell?: string;
  clearance_mm?: number;
  frames?: Frame[];
  bodies?: Body[];
  drifts?: Drift[];
  /** When each of the report's clearances is. */
  near_s?: (number | null)[];
}

// Report of a run, as of gsim run --json (docs/report.md); the parts that the page uses.

import type { RunStatus, Severity } from "./kinds";

/** Rounding of times in the report. */
export const SAME_TIME_S = 1e-9;

export type { Severity };

/** A line of a source. */
export interface SourceLocation {
  file: string;
  line: number;
}

/** Null: of no line. */
export interface LocatedEntry {
  file: string | null;
  line: number | null;
}

export interface ReportEvent extends LocatedEntry {
  t_s: number;
  kind: string;
  detail?: string;
}

export interface Violation extends LocatedEntry {
  t_s: number;
  axis: string;
  unit: string;
  value: number;
  limit: number;
  zone: string | null;
  message: string;
}

export interface Collision extends LocatedEntry {
  t_s: number;
  pair: [string, string];
  point_mm: [number, number, number];
  kind: "penetrating" | "touching";
}

export interface Clearance extends LocatedEntry {
  /** Time; missing if not known. */
  t_s?: number;
  clearance_mm: number;
  pair: [string, string];
  point_mm: [number, number, number];
}

export interface ReportDiagnostic extends LocatedEntry {
  severity: Severity;
  code: string;
  text: string;
  column?: number | null;
  end_column?: number | null;
  hint?: string | null;
}

/** Effort of an axis motor, N or Nm; null: not in the machine file. */
export interface AxisEffort extends LocatedEntry {
  axis: string;
  unit: string;
  t_s: number;
  peak: number;
  rms: number;
  motor_peak: number | null;
  motor_continuous: number | null;
  in_j: number;
  back_j: number;
  friction_j: number;
}

export interface EffortExcess extends LocatedEntry {
  t_s: number;
  axis: string;
  kind: "peak" | "continuous";
  message: string;
}

export interface Efforts {
  axes: AxisEffort[];
  in_j: number;
  back_j: number;
  friction_j: number;
  peak_power_w: number;
  peak_power_t_s: number;
  /** Null: the main one. */
  programs: { program: string | null; time_s: number; in_j: number; back_j: number }[];
  excesses: EffortExcess[];
  excess_count: number;
}

/** Following error of an axis, mm or deg. */
export interface AxisFollowing extends LocatedEntry {
  axis: string;
  unit: string;
  lag_s: number;
  t_s: number;
  peak: number;
  rms: number;
}

/** Largest distance of the TCP from its path. */
export interface ContourError extends LocatedEntry {
  error_mm: number;
  t_s: number;
}

export interface Following {
  axes: AxisFollowing[];
  contour: ContourError;
  rapid_contour: ContourError;
  program_contour: ContourError | null;
  in_position_s: number | null;
}

export interface Report {
  program: string;
  machine: string;
  controller: string | null;
  status: RunStatus;
  alarm: (LocatedEntry & { code: string; message: string; axis: string | null }) | null;
  cycle_time_s: number;
  /** With violations: time after which the times are not those of the machine. */
  valid_until_s?: number | null;
  time?: { rapid_s: number; feed_s: number; dwell_s: number; words_s?: number };
  length?: { rapid_mm: number; feed_mm: number; process_on_mm: number };
  blocks?: number;
  moves?: number;
  process?: string;
  bounds?: Record<string, { min: number; max: number; limit_min: number | null; limit_max: number | null }>;
  violations?: Violation[];
  violation_count?: number;
  events?: ReportEvent[];
  warnings: string[];
  diagnostics?: ReportDiagnostic[];
  findings?: (LocatedEntry & { t_s: number; code: string; message: string })[];
  collisions?: Collision[];
  clearances?: Clearance[];
  cell?: { name: string; clearance_mm: number; checked?: { pairs: number; with_robots?: number } };
  time_by_limit?: { limited_by: string; time_s: number }[];
  lower_bound_s?: number | null;
  efforts?: Efforts;
  following?: Following;
  robots?: (Report & { name: string; idle_s: number })[];
}

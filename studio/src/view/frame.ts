import type { Matrix4 } from "three";
import type { Instant } from "./machine/machine";

/** Shown state: all robots at an instant, and the work frame of the selected one. */
export interface Frame {
  t_s: number;
  instants: Instant[];
  work: Matrix4;
}

import type { Matrix4 } from "three";
import type { Instant } from "./machine/machine";

/** What is shown: all robots at an instant, and the work frame of the one in question. */
export interface Frame {
  t_s: number;
  instants: Instant[];
  work: Matrix4;
}

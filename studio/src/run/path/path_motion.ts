// Changes the motion to a point: another motion, an arc by its via point or by its centre.

import { arcTo, isPlainArc, arcPoint, type Arc } from "./path_arc";
import type { PointChange } from "./path_edit";
import { pointMotion, type MotionType, type Point } from "./path_file";
import { add, between, cross, distance, rounded, roundedVector, scaled, subtract, unit, type Vector } from "./vector";

const noArc: PointChange = { via_mm: undefined, center_mm: undefined, normal: undefined, turn_deg: undefined };
/** Distance of the first arc between two points from their chord, relative to its length. */
const ARC_HEIGHT_SHARE = 0.25;
const DEG_PER_RAD = 180 / Math.PI;

/** Returns a point next to the middle of a chord, to the right of the path as the tool looks down. */
function centerLeftOfChord(from: Vector, to: Vector, up: Vector): Vector {
  const chord = subtract(to, from);
  const lateral = unit(cross(chord, up)) ?? unit(cross(chord, [1, 0, 0])) ?? [0, 1, 0];
  return roundedVector(add(between(from, to, 0.5), scaled(lateral, ARC_HEIGHT_SHARE * Math.max(distance(from, to), 1))));
}

/** Returns the change to another motion; an arc begins as a flat one through a point next to the chord. */
export function motionChange(point: Point, motion: MotionType, from_mm: Vector | null, up: Vector): PointChange {
  const change: PointChange = { motion };
  if (motion === "circular")
    return { ...change, lead_mm: undefined, via_mm: centerLeftOfChord(from_mm ?? [0, 0, 0], point.position_mm, up) };
  if (motion !== "linear") change.lead_mm = undefined;
  return pointMotion(point) === "circular" ? { ...change, ...noArc } : change;
}

export const byVia = (via_mm: Vector): PointChange => ({ ...noArc, via_mm: roundedVector(via_mm) });

export const byCenter = ({ center, normal, turn_rad }: Arc): PointChange => ({
  ...noArc,
  center_mm: roundedVector(center),
  normal: roundedVector(normal),
  turn_deg: rounded(turn_rad * DEG_PER_RAD),
});

/** Returns the same arc by its centre, or by its via point; null: not possible. */
export function convertArc(point: Point, from_mm: Vector | null, kind: "via" | "center"): PointChange | null {
  const arc = from_mm && arcTo(from_mm, point);
  if (!from_mm || arc === null || typeof arc === "string") return null;
  if (kind === "center") return byCenter(arc);
  return isPlainArc(arc, from_mm, point.position_mm) ? byVia(arcPoint(arc, 0.5)) : null;
}

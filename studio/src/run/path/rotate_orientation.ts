// Rotation of an orientation, kept in its original form.

import { Quaternion } from "three";
import type { Chain } from "../chain";
import type { PointChange } from "./path_edit";
import { solveRotaryAxes } from "./rotary_solver";
import { toQuaternion, toRpy, toolDirection, type Orientation } from "./tool_direction";
import { rounded, roundedVector, type Vector } from "./vector";

/** Returns null if it cannot be rotated in this form, or is not defined. */
export function rotateOrientation(orientation: Orientation, turn: Quaternion, chain: Chain | null): PointChange | null {
  const { rpy_deg, rotary_deg } = orientation;
  const none = { tool_axis: undefined, rpy_deg: undefined, rotary_deg: undefined };
  if (rpy_deg) return { ...none, rpy_deg: roundedVector(toRpy(turn.clone().multiply(toQuaternion(rpy_deg)))) };
  const direction = toolDirection(orientation, chain)?.applyQuaternion(turn);
  if (!direction) return null;
  if (!rotary_deg) return { ...none, tool_axis: roundedVector(direction.toArray() as Vector) };
  const found = solveRotaryAxes(direction, rotary_deg, chain!);
  if (!found) return null;
  return { ...none, rotary_deg: Object.fromEntries(Object.entries(found).map(([letter, value]) => [letter, rounded(value)])) };
}

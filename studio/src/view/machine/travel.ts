// Travel of axes in a drawing: their ranges, or the part that the run uses if the ranges are wide compared
// with the work.

import type { Robot } from "../../run/run";
import type { Report } from "../../run/report";
import { jointValue } from "../../run/chain";

/** Lowest and highest value of a joint, mm or rad. */
export type Travel = [number, number];

// A range beyond this only lets any program fit, and does not describe the machine.
const MAX_TRAVEL_MM = 6000;
const MARGIN_MM = 60;

export function travels(robot: Robot, report: Report | null): Travel[] {
  return robot.scene.axes.map((axis) => {
    const used = report?.bounds?.[axis.letter];
    const [low, high] = [axis.min ?? -Infinity, axis.max ?? Infinity];
    if (axis.rotary) return [jointValue(axis, low), jointValue(axis, high)];
    if (high - low <= MAX_TRAVEL_MM) return [jointValue(axis, low), jointValue(axis, high)];
    const from = used?.min ?? 0;
    const to = used?.max ?? 0;
    const margin = MARGIN_MM + 0.25 * (to - from);
    return [jointValue(axis, Math.max(low, from - margin)), jointValue(axis, Math.min(high, to + margin))];
  });
}

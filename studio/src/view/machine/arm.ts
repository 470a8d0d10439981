// Drawing of a chain of joints that is not a gantry, as drums and bars between them.

import { Vector3 } from "three";
import { travelLength, type Skeleton } from "./skeleton";
import type { Parts } from "./parts";

export function buildArm(parts: Parts, skeleton: Skeleton): void {
  const { tool, tip } = skeleton;
  const stations = [...tool.map((axis) => axis.origin), tip];
  let reach_mm = 0;
  for (let i = 1; i < stations.length; ++i) reach_mm += stations[i].distanceTo(stations[i - 1]);
  const g = Math.min(Math.max(0.06 * reach_mm, 8), 90);
  const foot = stations[0].clone().setZ(Math.min(0, stations[0].z - 4 * g));
  parts.drum(0, foot, new Vector3(0, 0, 1), 2.2 * g, 0.5 * g, "structure");
  parts.bar(0, foot, stations[0], 1.3 * g, "structure");
  tool.forEach((axis, i) => {
    const thick = g * (1 - (0.5 * i) / tool.length);
    if (axis.rotary) parts.drum(axis.joint + 1, axis.origin, axis.along, 1.15 * thick, 2.6 * thick, "machine");
    else if (Number.isFinite(travelLength(axis.travel))) {
      const [from, to] = axis.travel.map((q) => axis.origin.clone().addScaledVector(axis.along, q));
      parts.bar(axis.parent, from, to, 0.4 * thick, "structure");
      const across = Math.abs(axis.along.z) < 0.7 ? new Vector3(0, 0, 1) : new Vector3(1, 0, 0);
      const side = across.cross(axis.along).normalize();
      parts.box(axis.joint + 1, axis.origin, [1.6 * thick, 1.6 * thick, 1.6 * thick], axis.along, side, "machine");
    }
    parts.bar(axis.joint + 1, axis.origin, stations[i + 1], 0.7 * thick, "structure");
  });
}

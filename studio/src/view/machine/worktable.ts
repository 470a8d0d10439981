// Carrier of the work: a fixed table, one on straight axes, one that rotates or tilts.

import { Vector3 } from "three";
import { isVertical, type DrawnAxis, type Skeleton } from "./skeleton";
import { workArea } from "./gantry";
import type { Parts } from "./parts";

const X = new Vector3(1, 0, 0);
const Y = new Vector3(0, 1, 0);

/** Draws the fixed table below the area that the tool reaches. */
function buildFixedTable(parts: Parts, skeleton: Skeleton): void {
  const { tip, partSize_mm: g } = skeleton;
  const { low, high } = workArea(skeleton);
  const size = high.clone().sub(low);
  const middle = low.clone().add(high).multiplyScalar(0.5).add(tip);
  middle.z = tip.z + low.z - 0.5 * g;
  parts.box(0, middle, [size.x + g, size.y + g, 0.5 * g], X, Y, "structure");
}

function buildLinearTable(parts: Parts, skeleton: Skeleton, axis: DrawnAxis, depth: number, radius: number): void {
  const { workOrigin, partSize_mm: g } = skeleton;
  if (isVertical(axis)) return;
  const middle = workOrigin.clone().setZ(workOrigin.z - depth);
  const across = new Vector3(0, 0, 1).cross(axis.along).normalize();
  parts.box(axis.joint + 1, middle, [2.4 * radius, 2.4 * radius, 0.6 * g], axis.along, across, "machine");
  const [from, to] = axis.travel.map((q) => q);
  const length = to - from + 2 * radius;
  for (const side of [-0.8 * radius, 0.8 * radius]) {
    const rail = middle.clone().addScaledVector(axis.along, (from + to) / 2).addScaledVector(across, side);
    rail.z -= 0.55 * g;
    parts.box(axis.parent, rail, [length, 0.6 * g, 0.5 * g], axis.along, across, "structure");
  }
}

function buildRotaryAxis(parts: Parts, skeleton: Skeleton, axis: DrawnAxis, radius: number): void {
  const { workOrigin, partSize_mm: g } = skeleton;
  if (isVertical(axis)) {
    parts.drum(axis.joint + 1, workOrigin.clone().setZ(workOrigin.z - 0.5 * g), axis.along, radius, 0.9 * g, "machine");
    return;
  }
  // A cradle beneath the table, held at both ends of its axis.
  const reach = radius + 1.2 * g;
  const floor = workOrigin.z - 1.4 * g;
  const across = new Vector3(0, 0, 1).cross(axis.along).normalize();
  const under = new Vector3(axis.origin.x, axis.origin.y, floor);
  parts.box(axis.joint + 1, under, [2 * reach, radius, 0.7 * g], axis.along, across, "machine");
  for (const side of [-reach, reach]) {
    const pivot = axis.origin.clone().addScaledVector(axis.along, side);
    parts.drum(axis.joint + 1, pivot, axis.along, 0.7 * g, 0.7 * g, "machine");
    parts.bar(axis.joint + 1, pivot, under.clone().addScaledVector(axis.along, side), 0.3 * g, "machine");
    const columnBase = axis.origin.clone().addScaledVector(axis.along, side * 1.25);
    parts.drum(axis.parent, columnBase, axis.along, 0.9 * g, 0.6 * g, "structure");
  }
}

export function buildTable(parts: Parts, skeleton: Skeleton): void {
  const { work, partSize_mm: g } = skeleton;
  if (work.length === 0) return buildFixedTable(parts, skeleton);
  const { low, high } = workArea(skeleton);
  const size = high.sub(low);
  const radius = Math.max(0.3 * Math.min(size.x || size.y || 10 * g, size.y || size.x || 10 * g), 2 * g);
  const turns = work.some((axis) => axis.rotary);
  let depth = (turns ? 2.4 : 0.4) * g;
  for (const axis of [...work].reverse()) {
    if (axis.rotary) buildRotaryAxis(parts, skeleton, axis, radius);
    else {
      buildLinearTable(parts, skeleton, axis, depth, radius);
      depth += 1.4 * g;
    }
  }
}

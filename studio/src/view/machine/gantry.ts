// Drawing of a machine with a tool on straight axes, the vertical one last: rails, a bridge with a carriage,
// a ram.

import { Vector3 } from "three";
import { isVertical, travelLength, type DrawnAxis, type Skeleton } from "./skeleton";
import type { Parts } from "./parts";

const Z = new Vector3(0, 0, 1);

interface Heights {
  low: number;
  high: number;
  /** Distance from the TCP to the start of the ram. */
  head: number;
  bridge: number;
}

export const isGantry = ({ tool }: Skeleton): boolean => {
  const straight = tool.filter((axis) => !axis.rotary);
  const firstRotary = tool.findIndex((axis) => axis.rotary);
  const inOrder = firstRotary < 0 || firstRotary === straight.length;
  return straight.length >= 1 && straight.length <= 3 && inOrder && straight.findIndex(isVertical) === straight.length - 1;
};

function gantryHeights(skeleton: Skeleton, upright: DrawnAxis, gauge: number): Heights {
  const { tip, tool } = skeleton;
  const ends = upright.travel.map((q) => tip.z + upright.along.z * q);
  const [low, high] = [Math.min(...ends), Math.max(...ends)];
  const rotary = tool.filter((axis) => axis.rotary);
  const top = Math.max(0, ...rotary.map((axis) => axis.origin.z - tip.z));
  const head = rotary.length === 0 ? 1.6 * gauge : Math.max(2.6 * gauge, top + gauge);
  return { low, high, head, bridge: high + head + 1.8 * gauge };
}

/** Draws rails, bridge and carriage for the axes before the vertical one. */
function buildBridge(parts: Parts, skeleton: Skeleton, level: DrawnAxis[], heights: Heights): void {
  const { tip, partSize_mm: g } = skeleton;
  const [first, second] = level.length === 2 ? level : [null, level[0]];
  const along = second.along;
  const across = first ? first.along.clone() : along.clone().cross(Z).normalize();
  const behind = -1.5 * g;
  const at = (u: number, v: number, z: number) =>
    new Vector3(tip.x, tip.y, 0).addScaledVector(across, u).addScaledVector(along, v).setZ(z);
  const [low, high] = [second.travel[0] - 2.2 * g, second.travel[1] + 2.2 * g];
  const carrier = second.parent;
  const beam: [number, number, number] = [1.2 * g, high - low, 1.8 * g];
  parts.box(carrier, at(behind, (low + high) / 2, heights.bridge), beam, across, along, "structure");
  const foot = heights.low - g;
  for (const side of [low, high]) {
    const size: [number, number, number] = [1.6 * g, g, heights.bridge - foot];
    parts.box(carrier, at(behind, side, (heights.bridge + foot) / 2), size, across, along, "structure");
    if (!first) continue;
    const [from, to] = [first.travel[0] + behind - 2 * g, first.travel[1] + behind + 2 * g];
    const rail: [number, number, number] = [to - from, 0.8 * g, 0.8 * g];
    parts.box(first.parent, at((from + to) / 2, side, foot - 0.4 * g), rail, across, along, "machine");
  }
  const carriage: [number, number, number] = [1.5 * g, 2 * g, 2.6 * g];
  parts.box(second.joint + 1, at(0, 0, heights.bridge), carriage, across, along, "machine");
}

export function buildGantry(parts: Parts, skeleton: Skeleton): void {
  const { tip, partSize_mm: g, tool } = skeleton;
  const straight = tool.filter((axis) => !axis.rotary);
  const upright = straight[straight.length - 1];
  const level = straight.slice(0, -1);
  const heights = gantryHeights(skeleton, upright, g);
  if (level.length > 0) buildBridge(parts, skeleton, level, heights);
  // At the lowest position its upper end is still in the carriage.
  const bottom = tip.z + heights.head;
  const top = tip.z + heights.bridge - heights.low + 1.6 * g;
  const u = level[0]?.along ?? new Vector3(1, 0, 0);
  const v = Z.clone().cross(u).normalize();
  const middle = new Vector3(tip.x, tip.y, (top + bottom) / 2);
  parts.box(upright.joint + 1, middle, [g, g, top - bottom], v.clone().cross(Z), v, "machine");
  for (const axis of tool) if (axis.rotary) buildRotaryAxis(parts, skeleton, axis, heights.head);
}

/** Draws a drum on the tool's own axis if the joint rotates about it; else an arm next to the tool. */
function buildRotaryAxis(parts: Parts, skeleton: Skeleton, axis: DrawnAxis, head: number): void {
  const { tip, partSize_mm: g } = skeleton;
  const offset = axis.origin.z - tip.z;
  const above = (z: number, sideOffset = 0) => tip.clone().addScaledVector(Z, z).addScaledVector(axis.along, sideOffset);
  if (isVertical(axis)) {
    parts.drum(axis.joint + 1, above(head - 0.3 * g), Z, 0.6 * g, 0.6 * g, "machine");
    return;
  }
  const sideOffset = 1.1 * g;
  parts.bar(axis.parent, above(head - 0.5 * g), above(head - 0.5 * g, sideOffset), 0.2 * g, "machine");
  parts.bar(axis.parent, above(head - 0.5 * g, sideOffset), above(offset, sideOffset), 0.2 * g, "machine");
  parts.drum(axis.parent, above(offset, sideOffset), axis.along, 0.4 * g, 0.5 * g, "machine");
  const held = offset > 0.5 * g ? offset : 0.9 * g;
  parts.drum(axis.joint + 1, above(offset, sideOffset - 0.35 * g), axis.along, 0.34 * g, 0.3 * g, "structure");
  parts.bar(axis.joint + 1, above(offset, sideOffset - 0.35 * g), above(held, 0), 0.14 * g, "structure");
}

/** Returns the area that the tool covers, along the horizontal axes. */
export function workArea({ tool, work }: Skeleton): { low: Vector3; high: Vector3 } {
  const low = new Vector3();
  const high = new Vector3();
  for (const [axes, sign] of [
    [tool, 1],
    [work, -1],
  ] as [DrawnAxis[], number][]) {
    for (const axis of axes) {
      if (axis.rotary || !Number.isFinite(travelLength(axis.travel))) continue;
      const ends = axis.travel.map((q) => axis.along.clone().multiplyScalar(sign * q));
      low.add(ends[0].clone().min(ends[1]));
      high.add(ends[0].clone().max(ends[1]));
    }
  }
  return { low, high };
}

// Axes of a machine for a drawing of it: position and direction of each with all joints at 0.

import { Vector3 } from "three";
import type { LinkPoses } from "../../run/chain";
import type { Branch, Scene } from "../../run/scene";
import type { Travel } from "./travel";

export interface DrawnAxis {
  joint: number;
  rotary: boolean;
  /** Unit vector in the world. */
  along: Vector3;
  origin: Vector3;
  travel: Travel;
  /** Number of the link that carries it. */
  parent: number;
}

export interface Skeleton {
  tool: DrawnAxis[];
  work: DrawnAxis[];
  /** Tool centre point, and the origin of the work. */
  tip: Vector3;
  workOrigin: Vector3;
  /** Typical round size of its parts, mm. */
  partSize_mm: number;
}

const matrixPosition = (matrix: { elements: number[] }) => new Vector3().fromArray(matrix.elements, 12);

function branchAxes(branch: Branch, zero: LinkPoses, travels: Travel[]): DrawnAxis[] {
  let parent = 0;
  return branch.links.map(({ joint, rotary }) => {
    const frame = zero.joints[joint];
    const axis: DrawnAxis = {
      joint,
      rotary,
      along: new Vector3().setFromMatrixColumn(frame, 2).normalize(),
      origin: matrixPosition(frame),
      travel: travels[joint],
      parent,
    };
    parent = joint + 1;
    return axis;
  });
}

export const travelLength = ([low, high]: Travel): number => high - low;
export const isVertical = (axis: DrawnAxis): boolean => Math.abs(axis.along.z) > 0.7;

export function createSkeleton(scene: Scene, zero: LinkPoses, travels: Travel[]): Skeleton {
  const tool = branchAxes(scene.tool_side, zero, travels);
  const work = branchAxes(scene.work_side, zero, travels);
  const linear = [...tool, ...work].filter((axis) => !axis.rotary).map((axis) => travelLength(axis.travel));
  const size_mm = linear.length > 0 ? Math.max(...linear) : 0;
  return {
    tool,
    work,
    tip: matrixPosition(zero.tool),
    workOrigin: matrixPosition(zero.work),
    partSize_mm: Math.min(Math.max(0.035 * size_mm, 10), 90),
  };
}

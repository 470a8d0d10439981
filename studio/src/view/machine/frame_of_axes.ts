// Axes of a machine for a drawing of it: position and direction of each with all joints at 0.

import { Vector3 } from "three";
import type { Places } from "../../run/chain";
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
  ground: Vector3;
  /** Typical round size of its parts, mm. */
  gauge_mm: number;
}

const positionOf = (matrix: { elements: number[] }) => new Vector3().fromArray(matrix.elements, 12);

function axesOf(branch: Branch, zero: Places, ways: Travel[]): DrawnAxis[] {
  let parent = 0;
  return branch.links.map(({ joint, rotary }) => {
    const frame = zero.joints[joint];
    const axis: DrawnAxis = {
      joint,
      rotary,
      along: new Vector3().setFromMatrixColumn(frame, 2).normalize(),
      origin: positionOf(frame),
      travel: ways[joint],
      parent,
    };
    parent = joint + 1;
    return axis;
  });
}

export const lengthOf = ([low, high]: Travel): number => high - low;
export const isUpright = (axis: DrawnAxis): boolean => Math.abs(axis.along.z) > 0.7;

export function skeletonOf(scene: Scene, zero: Places, ways: Travel[]): Skeleton {
  const tool = axesOf(scene.tool_side, zero, ways);
  const work = axesOf(scene.work_side, zero, ways);
  const linear = [...tool, ...work].filter((axis) => !axis.rotary).map((axis) => lengthOf(axis.travel));
  const size_mm = linear.length > 0 ? Math.max(...linear) : 0;
  return {
    tool,
    work,
    tip: positionOf(zero.tool),
    ground: positionOf(zero.work),
    gauge_mm: Math.min(Math.max(0.035 * size_mm, 10), 90),
  };
}

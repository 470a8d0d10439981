// Direction of the tool from its TCP, for all forms in a path: by a direction, by angles, or by rotary axes
// of a machine.

import { Euler, Matrix4, Quaternion, Vector3 } from "three";
import { RAD_PER_DEG, jointValue, type Chain } from "../chain";
import type { Axis } from "../scene";
import type { Point } from "./path_file";
import type { Vector } from "./vector";

export type Orientation = Pick<Point, "tool_axis" | "rpy_deg" | "rotary_deg">;
export const orientationKinds = ["tool_axis", "rpy_deg", "rotary_deg"] as const;
export type OrientationKind = (typeof orientationKinds)[number];

/** Returns null without an orientation. */
export const orientationKind = (orientation: Orientation): OrientationKind | null =>
  orientationKinds.find((kind) => orientation[kind] !== undefined) ?? null;

/** Returns R = Rz(roll) Ry(pitch) Rx(yaw). */
export function toQuaternion([roll, pitch, yaw]: Vector): Quaternion {
  return new Quaternion().setFromEuler(new Euler(yaw * RAD_PER_DEG, pitch * RAD_PER_DEG, roll * RAD_PER_DEG, "ZYX"));
}

export function toRpy(rotation: Quaternion): Vector {
  const { x, y, z } = new Euler().setFromQuaternion(rotation, "ZYX");
  return [z / RAD_PER_DEG, y / RAD_PER_DEG, x / RAD_PER_DEG];
}

/** Returns the tool's frame in that of the work. */
export function toolInWork(chain: Chain, joints: ArrayLike<number>, t_s = 0): Matrix4 {
  const { tool, work } = chain.linkPoses(joints, t_s);
  return work.invert().multiply(tool);
}

/** Returns joints with rotary axes at values in deg, by letter, and the others at the given values. */
export const jointsWith = (axes: Axis[], rotary_deg: Record<string, number>, others: ArrayLike<number>): number[] =>
  axes.map((axis, i) => (axis.rotary && axis.letter in rotary_deg ? jointValue(axis, rotary_deg[axis.letter]) : others[i]));

/** Returns null if it is not defined, or needs an unknown machine. */
export function toolDirection(orientation: Orientation, chain: Chain | null): Vector3 | null {
  const { tool_axis, rpy_deg, rotary_deg } = orientation;
  if (tool_axis) return new Vector3(...tool_axis).normalize();
  if (rpy_deg) return new Vector3(0, 0, 1).applyQuaternion(toQuaternion(rpy_deg));
  if (!rotary_deg || !chain) return null;
  const { axes } = chain.scene;
  const joints = jointsWith(axes, rotary_deg, new Float64Array(axes.length));
  return new Vector3().setFromMatrixColumn(toolInWork(chain, joints), 2).normalize();
}

// Engine data about a pose of the machine: the joints for a TCP, and the contacts there.

import type { Session } from "../../core/session";

export interface Pose {
  /** Values of the axes, mm and deg. */
  joints: number[];
  tip_mm: number[];
  tool_axis: number[];
  rpy_deg: number[];
  /** -1, 0 or 1 for each axis: below, within, above its range. */
  beyond: number[];
  collisions: [string, string][];
}

export type PoseRequest =
  | { joints: readonly number[] }
  | { tip_mm: readonly number[]; tool_axis?: readonly number[]; rpy_deg?: readonly number[]; near: readonly number[] };

/** Returns a message if such a pose does not exist. */
export async function requestPose(session: Session, requested: PoseRequest, tool_mm: number): Promise<Pose | string> {
  const { machine, machine_data, cell } = session.setup;
  const { ok, message, messages } = await session.sendRequest({ do: "pose", machine, machine_data, cell, ...requested, tool_mm });
  const found = messages.find(({ is }) => is === "pose");
  return ok && found ? (found.header as unknown as Pose) : message;
}

// What the engine knows of a pose of the machine: the joints that lead to a tip, and what touches there.

import type { Session } from "../../core/session";

export interface Pose {
  /** Values of the axes, mm and deg. */
  joints: number[];
  tip_mm: number[];
  tool_axis: number[];
  rpy_deg: number[];
  /** For each axis -1, 0 or 1: below, within, above its range. */
  beyond: number[];
  collisions: [string, string][];
}

export type PoseWanted =
  | { joints: readonly number[] }
  | { tip_mm: readonly number[]; tool_axis?: readonly number[]; rpy_deg?: readonly number[]; near: readonly number[] };

/** A sentence where there is no such pose. */
export async function poseOf(session: Session, wanted: PoseWanted, tool_mm: number): Promise<Pose | string> {
  const { machine, machine_data, cell } = session.setup;
  const { ok, message, messages } = await session.question({ do: "pose", machine, machine_data, cell, ...wanted, tool_mm });
  const found = messages.find(({ is }) => is === "pose");
  return ok && found ? (found.header as unknown as Pose) : message;
}

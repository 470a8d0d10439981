// Point at the position of the tool in the run at the shown instant, or at its position when moved by hand.

import { Vector3 } from "three";
import { shownRobot } from "../../core/display_state";
import type { Store } from "../../core/store";
import type { Point } from "../../run/path/path_file";
import { toolInWork } from "../../run/path/tool_direction";
import { roundedVector, type Vector } from "../../run/path/vector";

/** Returns the origin if nothing has run, or null if the position is not loaded yet. */
export function currentPoint(store: Store): Pick<Point, "position_mm" | "tool_axis"> | null {
  const robot = shownRobot(store);
  if (!robot) return { position_mm: [0, 0, 0] };
  const t_s = store.get("time_s");
  const joints = store.get("jog") ?? robot.joints_at(t_s);
  const number = robot.tcp_at(t_s);
  if (!joints || number === null) return null;
  const frame = toolInWork(robot.chain, joints, t_s);
  const tip = new Vector3(...(robot.scene.tcps_mm[number] ?? [0, 0, 0])).applyMatrix4(frame);
  const turns = robot.scene.axes.some(({ rotary }) => rotary);
  const axis = roundedVector(new Vector3().setFromMatrixColumn(frame, 2).toArray() as Vector);
  return { position_mm: roundedVector(tip.toArray() as Vector), ...(turns && { tool_axis: axis }) };
}

// Goes to a place of a run: what is shown is its instant, what is chosen its line.

import type { Place, Placed } from "../run/report";
import { robotOf } from "./shown";
import type { Store } from "./store";

/** The block of a line that is under way at an instant, else the one that is nearest; -1: the line moves nothing. */
function blockAt(store: Store, { file, line }: Place, t_s: number): number {
  const robot = robotOf(store);
  return robot ? robot.blocks.nearest(robot.files.indexOf(file), line, t_s) : -1;
}

/** Shows an instant; null leaves it as it is. */
export function goTo(store: Store, { file, line }: Placed, t_s: number | null): void {
  if (t_s !== null) store.set("time_s", t_s);
  if (file === null || line === null) return;
  store.set("selection", { file, line, block: blockAt(store, { file, line }, store.get("time_s")) });
}

/** Shows where a block of the robot that is shown begins; what is chosen stays. */
export function showStart(store: Store, block: number): void {
  const robot = robotOf(store);
  if (!robot) return;
  const { blocks, segments } = robot;
  const first = blocks.first(block);
  const t_s = blocks.start_s(block);
  store.set("time_s", t_s);
  if (segments.locate(first)) return;
  // By vertices it is some milliseconds off.
  void segments.need(first).then((isHere) => {
    if (isHere && robotOf(store) === robot && store.get("time_s") === t_s) store.set("time_s", blocks.start_s(block));
  });
}

/** As showStart(), and chooses the block. */
export function goToBlock(store: Store, block: number): void {
  const robot = robotOf(store);
  if (!robot) return;
  const { file, line } = robot.blocks.get(block);
  showStart(store, block);
  store.set("selection", { file: robot.files[file] ?? "", line, block });
}

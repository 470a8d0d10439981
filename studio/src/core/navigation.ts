// Navigation to a position of a run: its instant is shown, its line chosen.

import type { SourceLocation, LocatedEntry } from "../run/report";
import { shownRobot } from "./display_state";
import type { Store } from "./store";

/** Returns the block of a line at an instant, else the nearest one; -1: the line moves no axis. */
function blockAt(store: Store, { file, line }: SourceLocation, t_s: number): number {
  const robot = shownRobot(store);
  return robot ? robot.blocks.nearest(robot.files.indexOf(file), line, t_s) : -1;
}

/** Shows an instant; null leaves it unchanged. */
export function goTo(store: Store, { file, line }: LocatedEntry, t_s: number | null): void {
  if (t_s !== null) store.set("time_s", t_s);
  if (file === null || line === null) return;
  store.set("selection", { file, line, block: blockAt(store, { file, line }, store.get("time_s")) });
}

/** Shows the start of a block of the shown robot; the selection stays. */
export function showBlockStart(store: Store, block: number): void {
  const robot = shownRobot(store);
  if (!robot) return;
  const { blocks, segments } = robot;
  const first = blocks.first(block);
  const t_s = blocks.start_s(block);
  store.set("time_s", t_s);
  if (segments.locate(first)) return;
  // The time from vertices is inaccurate by some milliseconds.
  void segments.fetchNow(first).then((isHere) => {
    if (isHere && shownRobot(store) === robot && store.get("time_s") === t_s) store.set("time_s", blocks.start_s(block));
  });
}

/** Does the same as showBlockStart(), and chooses the block. */
export function goToBlock(store: Store, block: number): void {
  const robot = shownRobot(store);
  if (!robot) return;
  const { file, line } = robot.blocks.get(block);
  showBlockStart(store, block);
  store.set("selection", { file: robot.files[file] ?? "", line, block });
}

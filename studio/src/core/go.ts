// Goes to a place of a run: what is shown is its instant, what is chosen its line.

import type { Robot } from "../run/run";
import type { Placed } from "../run/report";
import type { Store } from "./store";

/** The block of a line that is under way at an instant or begins next after it; -1: the line moves nothing. */
export function blockAt(robot: Robot, file: string, line: number, t_s: number): number {
  const blocks = robot.blocks.ofLine(robot.files.indexOf(file), line);
  const start_s = (block: number) => robot.segments.info(robot.blocks.first.at(block)).start_s;
  let [low, high] = [0, blocks.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (start_s(blocks[middle]) < t_s - 1e-9) low = middle + 1;
    else high = middle;
  }
  const after = low < blocks.length && start_s(blocks[low]) <= t_s + 1e-9 ? low : low - 1;
  return blocks[Math.max(after, 0)] ?? -1;
}

/** Shows an instant; null leaves it as it is. */
export function goTo(store: Store, { file, line }: Placed, t_s: number | null): void {
  const robot = store.get("run")?.robots[store.get("robot")];
  if (t_s !== null) store.set("time_s", t_s);
  if (file === null || line === null) return;
  const block = robot ? blockAt(robot, file, line, t_s ?? store.get("time_s")) : -1;
  store.set("selection", { file, line, block });
}

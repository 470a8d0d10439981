// Steps from block to block and from mark to mark.

import { goTo, showBlockStart } from "../core/navigation";
import { clockEnd_s, shownRobot } from "../core/display_state";
import type { Store } from "../core/store";
import type { Mark } from "../run/marks";
import { SAME_TIME_S } from "../run/report";
import type { Robot } from "../run/run";
import { lastIndex } from "../run/search";

export function goToStart(store: Store): void {
  store.set("time_s", 0);
}

export function goToEnd(store: Store): void {
  store.set("time_s", clockEnd_s(store));
}

/** Moves to the start of the previous or next block; from within a block back to its own start. */
export function stepBlock(store: Store, by: 1 | -1): void {
  const robot = shownRobot(store);
  if (!robot || robot.segments.count === 0) return;
  const { segments } = robot;
  const t_s = store.get("time_s");
  store.set("playing", false);
  const here = segments.at(t_s);
  if (segments.locate(here)) return stepFrom(store, robot, by);
  void segments.fetchNow(here).then(() => {
    if (shownRobot(store) === robot && store.get("time_s") === t_s) stepFrom(store, robot, by);
  });
}

function stepFrom(store: Store, { blocks, segments }: Robot, by: 1 | -1): void {
  const t_s = store.get("time_s");
  let block = blocks.of(segments.at(t_s));
  if (by > 0) while (block >= 0 && blocks.start_s(block) <= t_s + SAME_TIME_S) block = blocks.after(block);
  else while (blocks.before(block) >= 0 && blocks.start_s(block) >= t_s - SAME_TIME_S) block = blocks.before(block);
  if (block >= 0) showBlockStart(store, block);
  else goToEnd(store);
}

/** Returns the number of the first mark after an instant; `marks.length`: none. */
export const firstAfter = (marks: readonly Mark[], t_s: number): number =>
  lastIndex(marks.length, (i) => marks[i].t_s <= t_s) + 1;

/** Moves to the previous or next mark, and returns it. */
export function stepMark(store: Store, marks: readonly Mark[], by: 1 | -1): Mark | null {
  const t_s = store.get("time_s");
  const index = by > 0 ? firstAfter(marks, t_s + SAME_TIME_S) : firstAfter(marks, t_s - SAME_TIME_S) - 1;
  const mark = marks[index];
  if (!mark) return null;
  store.set("playing", false);
  goTo(store, mark, mark.t_s);
  return mark;
}

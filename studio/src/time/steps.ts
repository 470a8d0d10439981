// Steps from block to block and from mark to mark.

import { goTo } from "../core/go";
import type { Store } from "../core/store";
import type { Mark } from "../run/marks";
import type { Robot } from "../run/run";

// Times that come from different sums differ by roundings.
const SAME_S = 1e-9;

export const robotOf = (store: Store): Robot | undefined => store.get("run")?.robots[store.get("robot")];

export function goToStart(store: Store): void {
  store.set("time_s", 0);
}

export function goToEnd(store: Store): void {
  store.set("time_s", store.get("run")?.end_s ?? 0);
}

/** To the start of the block before or behind; from within a block back to its own start. */
export function stepBlock(store: Store, by: 1 | -1): void {
  const robot = robotOf(store);
  if (!robot || robot.segments.count === 0) return;
  const { blocks, segments } = robot;
  const t_s = store.get("time_s");
  const start_s = (block: number) => segments.info(blocks.first.at(block)).start_s;
  let block = blocks.of(segments.at(t_s));
  if (by > 0) while (block < blocks.count && start_s(block) <= t_s + SAME_S) ++block;
  else while (block > 0 && start_s(block) >= t_s - SAME_S) --block;
  store.set("playing", false);
  store.set("time_s", block < blocks.count ? start_s(block) : segments.end_s);
}

/** The first mark that is later than an instant, by its number; `marks.length`: there is none. */
export function firstAfter(marks: readonly Mark[], t_s: number): number {
  let [low, high] = [0, marks.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (marks[middle].t_s <= t_s) low = middle + 1;
    else high = middle;
  }
  return low;
}

/** Goes to the mark before or behind, and returns it. */
export function stepMark(store: Store, marks: readonly Mark[], by: 1 | -1): Mark | null {
  const t_s = store.get("time_s");
  const index = by > 0 ? firstAfter(marks, t_s + SAME_S) : firstAfter(marks, t_s - SAME_S) - 1;
  const mark = marks[index];
  if (!mark) return null;
  store.set("playing", false);
  goTo(store, mark, mark.t_s);
  return mark;
}

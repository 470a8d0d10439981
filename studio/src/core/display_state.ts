// Shown part of the run: the robot for code, charts and tables, and its current line.

import type { SourceLocation } from "../run/report";
import type { Robot } from "../run/run";
import type { Store } from "./store";

/** Returns undefined if nothing has moved. */
export const shownRobot = (store: Store): Robot | undefined => store.get("run")?.robots[store.get("robot")];

/** Returns the end of the clock: that of the shown run or of the comparison run, whichever is later. */
export const clockEnd_s = (store: Store): number => Math.max(store.get("run")?.end_s ?? 0, store.get("comparisonRun")?.run.end_s ?? 0);

/**
 * Returns the active line at the shown instant, or null if none. The line of an event comes before that of
 * the motion that begins there; but if a user has selected one of them, that one.
 */
export function activeLine(store: Store): SourceLocation | null {
  const run = store.get("run");
  if (!run) return null;
  const [robot, t_s, chosen] = [store.get("robot"), store.get("time_s"), store.get("selection")];
  const places = run.locationsAt(robot, t_s);
  const moving = run.locationOfMotion(robot, t_s);
  const all = moving ? [...places, moving] : places;
  return all.find(({ file, line }) => file === chosen?.file && line === chosen.line) ?? all[0] ?? null;
}

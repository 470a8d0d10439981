// What of the run is shown: the robot that code, charts and tables are of, and the line that it is at.

import type { Place } from "../run/report";
import type { Robot } from "../run/run";
import type { Store } from "./store";

/** Undefined: nothing has moved. */
export const robotOf = (store: Store): Robot | undefined => store.get("run")?.robots[store.get("robot")];

/** When the clock ends: with the run that is shown, or with the one beside it, whichever takes longer. */
export const end_sOf = (store: Store): number => Math.max(store.get("run")?.end_s ?? 0, store.get("beside")?.run.end_s ?? 0);

/**
 * The line that is at work at the instant that is shown: an event's before that of the motion which begins there, but
 * where a person has chosen one of them, that one. Null: none is.
 */
export function lineAtWork(store: Store): Place | null {
  const run = store.get("run");
  if (!run) return null;
  const [robot, t_s, chosen] = [store.get("robot"), store.get("time_s"), store.get("selection")];
  const places = run.placesAt(robot, t_s);
  const moving = run.placeOfMotion(robot, t_s);
  const all = moving ? [...places, moving] : places;
  return all.find(({ file, line }) => file === chosen?.file && line === chosen.line) ?? all[0] ?? null;
}

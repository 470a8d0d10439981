// Times of the shown file's lines in the shown run.

import type { Store } from "../core/store";
import { percentText, timeText } from "../core/units";
import { texts } from "../texts";
import type { LineHeat } from "./heat";
import { lineTimes } from "./line_times";
import type { SourcePane } from "./source_pane";

/**
 * Returns true if the shown file has run, but its lines have no times because not all of the run is loaded.
 */
export function hasMissingTimes(store: Store, source: SourcePane): boolean {
  const run = store.get("run");
  const index = store.get("robot");
  return run !== null && run.fileOf(index, source.name) >= 0 && (run.robots[index]?.segments.isLong ?? false);
}

/** Returns null if the file has not run, or the run is so long that not all of it is loaded. */
export function runHeat(store: Store, source: SourcePane): LineHeat | null {
  const run = store.get("run");
  const index = store.get("robot");
  const robot = run?.robots[index];
  const file = run?.fileOf(index, source.name) ?? -1;
  if (!run || !robot || file < 0 || robot.segments.isLong) return null;
  const { times_s, slowest_s } = lineTimes(robot, file);
  if (slowest_s <= 0) return null;
  const cycle_s = run.end_s;
  return {
    of(line) {
      const time_s = times_s[source.editorFile.toRunLine(line)] ?? 0;
      if (time_s <= 0) return null;
      const text = texts.code.hover.share(timeText(time_s), percentText(time_s, cycle_s));
      return { share: time_s / slowest_s, text };
    },
  };
}

// Data that the tabs use.

import type { Store } from "../../core/store";
import type { Report } from "../../run/report";
import type { Robot, Run } from "../../run/run";

export interface Context {
  run: Run;
  /** Number of the robot, and the robot; undefined if nothing has moved. */
  index: number;
  robot: Robot | undefined;
  report: Report | null;
}

/** Returns null if nothing has run. */
export function runContext(store: Store): Context | null {
  const run = store.get("run");
  if (!run) return null;
  const index = store.get("robot");
  return { run, index, robot: run.robots[index], report: run.reportOf(index) };
}

/** Links from one tab to another: blocks that match some words. */
export interface Links {
  showBlocks(filter: string): void;
}

/** Content of a tab: redrawn for each run, robot and unit, while it is visible. */
export interface Tab {
  element: HTMLElement;
  draw(context: Context): void;
  /**
   * Called when another run is shown and the tab is not visible: data of the previous run would fill the
   * page's memory.
   */
  forget?(): void;
}

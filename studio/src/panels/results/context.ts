// What the tabs work with.

import type { Store } from "../../core/store";
import type { Report } from "../../run/report";
import type { Robot, Run } from "../../run/run";

export interface Context {
  run: Run;
  /** Its number, and itself; undefined where nothing has moved. */
  index: number;
  robot: Robot | undefined;
  report: Report | null;
}

/** null: nothing has run. */
export function contextOf(store: Store): Context | null {
  const run = store.get("run");
  if (!run) return null;
  const index = store.get("robot");
  return { run, index, robot: run.robots[index], report: run.reportOf(index) };
}

/** What a tab shows can be put into other tabs: the blocks that match some words. */
export interface Links {
  showBlocks(filter: string): void;
}

/** A tab's content: drawn anew for each run, robot and unit, when it is looked at. */
export interface Tab {
  element: HTMLElement;
  draw(context: Context): void;
  /** Another run is shown, and this is not looked at: what a tab still held of the one before would fill the page's memory. */
  forget?(): void;
}

// Results of a run: its status, the slowest blocks, shares of time, events, the previous run.

import "./results.css";
import { choice, element } from "../../core/dom";
import type { Store } from "../../core/store";
import { texts } from "../../texts";
import { runContext, type Tab } from "./context";
import { createStatus } from "./status";
import { createBlocks } from "./tabs/blocks";
import { createCompare } from "./tabs/compare";
import { createEvents } from "./tabs/events";
import { createTimeShares } from "./tabs/shares";
import { createSummary } from "./tabs/summary";
import { createTabs } from "../tab_bar";

const words = texts.panels;

export function createResults(host: HTMLElement, store: Store): void {
  const blocks = createBlocks(store);
  const links = {
    showBlocks: (filter: string) => {
      blocks.filter(filter);
      tabs.choose("blocks");
    },
  };
  const all: Record<keyof typeof words.tabs, Tab> = {
    summary: createSummary(store),
    blocks,
    shares: createTimeShares(store, links),
    events: createEvents(store),
    compare: createCompare(store),
  };
  const staleTabs = new Set<string>();
  const draw = (name: string) => {
    const context = runContext(store);
    if (context && staleTabs.delete(name)) all[name as keyof typeof all].draw(context);
  };
  const tabs = createTabs(words.results, words.tabs, all, "results", draw);
  const robots = element("div", { class: "robots" });
  const content = element("div", { class: "tabs" }, tabs.bar, ...tabs.panels);
  host.append(element("div", { class: "results" }, createStatus(store), robots, content));

  store.watch(["run", "robot"], () => {
    const run = store.get("run");
    // The previous run may have had more robots.
    if (store.get("robot") >= (run?.robots.length ?? 0)) store.set("robot", 0);
    const options = (run?.robots ?? []).map(({ name }, i) => [String(i), name] as const);
    robots.hidden = options.length < 2;
    robots.replaceChildren(
      element("label", {}, `${words.robot} `),
      choice(words.robot, options, String(store.get("robot")), (value) => store.set("robot", Number(value))),
    );
    content.hidden = !run?.report || run.error !== null;
  });
  store.watch(["run", "robot", "units", "previous"], () => {
    const isVisible = (name: string) => name === tabs.chosen && runContext(store) !== null;
    for (const [name, tab] of Object.entries(all) as [string, Tab][]) {
      staleTabs.add(name);
      if (!isVisible(name)) tab.forget?.();
    }
    draw(tabs.chosen);
  });
}

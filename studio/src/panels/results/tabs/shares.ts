// Shares of the time: by the limits of the moves, by kind, tool and operation.

import { kindColours, orange } from "../../../core/colours";
import { element } from "../../../core/dom";
import { goToBlock } from "../../../core/navigation";
import { limitText } from "../../../core/display_names";
import type { Store } from "../../../core/store";
import { percentText, timeText } from "../../../core/units";
import { limitOfReport, type NamedLimit } from "../../../run/limits";
import { moveKinds } from "../../../run/kinds";
import { texts } from "../../../texts";
import type { Context, Links, Tab } from "../context";
import { cachedBlockTable, type BlockTable } from "../data/block_table";
import { limitColour, limitHint, blockLimit } from "../data/limit_texts";
import { timeByOperation } from "../data/operations";
import { timeByTool } from "../data/tools";

const words = texts.panels;

interface TimeShare {
  name: string;
  time_s: number;
  colour: string;
  title: string;
  choose(): void;
}

export function createTimeShares(store: Store, links: Links): Tab {
  const host = element("div", { class: "shares" });
  return {
    element: host,
    draw(context) {
      const { run, robot, report } = context;
      host.replaceChildren();
      if (!robot || !report) return;
      const table = cachedBlockTable(robot);
      const operations = timeByOperation(run, robot, table, words.unnamed).map((operation) => ({
        name: operation.name,
        time_s: operation.time_s,
        colour: orange,
        title: `${operation.name}: ${words.goThere}`,
        choose: () => goToBlock(store, operation.first),
      }));
      const tools = timeByTool(report).map((tool) => ({
        name: tool.name || words.noTool,
        time_s: tool.time_s,
        colour: orange,
        title: words.goThere,
        choose: () => store.set("time_s", tool.start_s),
      }));
      const isLong = robot.segments.isLong;
      const tabulated_s = isLong ? table.total_s : report.cycle_time_s;
      host.append(
        ...createBars(words.sharesByLimit, "", sharesByLimit(context, table, links), report.cycle_time_s),
        ...createBars(words.byTool, "", tools, report.cycle_time_s),
        ...(isLong ? [element("p", { class: "note" }, words.onlyFirst)] : []),
        ...createBars(words.byOperation, words.byOperationHint, operations, tabulated_s),
        ...createBars(words.sharesByKind, "", sharesByKind(table, links), tabulated_s),
      );
    },
  };
}

/** Uses the report, which counts each sub-segment separately; else the longest part of each block. */
function sharesByLimit({ robot, report }: Context, table: BlockTable, links: Links): TimeShare[] {
  const times = new Map<string, { limit: NamedLimit; time_s: number }>();
  const add = (limit: NamedLimit, time_s: number) => {
    const name = limitText(limit);
    times.set(name, { limit, time_s: (times.get(name)?.time_s ?? 0) + time_s });
  };
  if (report?.time_by_limit) {
    for (const { limited_by, time_s } of report.time_by_limit) add(limitOfReport(limited_by), time_s);
  } else {
    const { letters } = robot!;
    for (let block = 0; block < table.count; ++block) add(blockLimit(table, block, letters), table.duration_s[block]);
  }
  return [...times]
    .map(([name, { limit, time_s }]) => ({
      name,
      time_s,
      colour: limitColour(limit),
      title: `${limitHint(limit)} ${words.filterBlocks}`,
      choose: () => links.showBlocks(name),
    }))
    .sort((a, b) => b.time_s - a.time_s);
}

function sharesByKind(table: BlockTable, links: Links): TimeShare[] {
  const times_s = new Float64Array(moveKinds.length);
  for (let block = 0; block < table.count; ++block) times_s[table.kind[block]] += table.duration_s[block];
  return moveKinds
    .map((kind, i) => ({
      name: texts.run.kinds[kind],
      time_s: times_s[i],
      colour: kindColours[kind],
      title: words.filterBlocks,
      choose: () => links.showBlocks(texts.run.kinds[kind]),
    }))
    .filter(({ time_s }) => time_s > 0)
    .sort((a, b) => b.time_s - a.time_s);
}

/** Returns an empty list if nothing can be distinguished. */
function createBars(title: string, hint: string, shares: TimeShare[], run_time_s: number): HTMLElement[] {
  if (shares.length === 0) return [];
  const most_s = Math.max(...shares.map(({ time_s }) => time_s), 1e-12);
  const rows = shares.map(({ name, time_s, colour, title: tip, choose }) =>
    element(
      "button",
      { class: "share", title: tip, onclick: choose, style: `--colour:${colour};--share:${(100 * time_s) / most_s}%` },
      element("span", { class: "share-name" }, name),
      element("span", { class: "share-time" }, `${timeText(time_s, 2)} · ${percentText(time_s, run_time_s)} %`),
    ),
  );
  return [element("section", {}, element("h3", { class: "heading", title: hint }, title), ...rows)];
}

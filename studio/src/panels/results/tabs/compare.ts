// Comparison of the run with the previous one.

import { check, element } from "../../../core/dom";
import { goTo, goToBlock } from "../../../core/navigation";
import type { Store } from "../../../core/store";
import { percentText, timeText } from "../../../core/units";
import { texts } from "../../../texts";
import type { Context, Tab } from "../context";
import { compare, MIN_DIFFERENCE_S, type Comparison, type Row } from "../data/comparison";
import { initializeTabStops, makeRows } from "../rows";

const words = texts.panels;
const MAX_ROWS = 200;

const signedTime = (difference_s: number): string =>
  `${difference_s < 0 ? "−" : "+"}${timeText(Math.abs(difference_s))}`;

export function createCompare(store: Store): Tab {
  const host = element("div", { class: "compare" });
  const both = check(words.drawBoth, (on) => store.set("compare", on));
  store.watch(["compare"], () => (both.box.checked = store.get("compare")));
  return {
    element: host,
    forget: () => host.replaceChildren(),
    draw(context) {
      const previous = store.get("previous");
      if (context.run.isLong) return host.replaceChildren(element("p", { class: "note" }, words.tooLong));
      if (!previous) return host.replaceChildren(element("p", { class: "note" }, words.noPrevious));
      const status = context.run.report?.status;
      if (status !== "completed" && status !== "violations") {
        return host.replaceChildren(element("p", { class: "note" }, words.unfinished));
      }
      if (previous.report?.program !== context.run.report?.program) {
        return host.replaceChildren(element("p", { class: "note" }, words.otherProgram(previous.report?.program ?? "")));
      }
      const comparison = compare(previous, context.run, context.index, MAX_ROWS);
      if (!comparison) return host.replaceChildren(element("p", { class: "note" }, words.otherMachine));
      host.replaceChildren(total(comparison), both.row, ...table(comparison, context, store));
    },
  };
}

function total({ before_s, after_s }: Comparison): HTMLElement {
  const difference_s = after_s - before_s;
  const size = timeText(Math.abs(difference_s));
  const percent = percentText(Math.abs(difference_s), before_s);
  const same = Math.abs(difference_s) < MIN_DIFFERENCE_S;
  const faster = difference_s < 0;
  const sentence = same ? words.same : faster ? words.faster(size, percent) : words.slower(size, percent);
  return element(
    "dl",
    { class: "figures" },
    element("div", { class: "figure" }, element("dt", {}, words.before), element("dd", {}, timeText(before_s))),
    element("div", { class: "figure" }, element("dt", {}, words.after), element("dd", {}, timeText(after_s))),
    element(
      "div",
      { class: `figure great ${same ? "" : faster ? "faster" : "slower"}` },
      element("dt", {}, words.difference),
      element("dd", {}, sentence),
    ),
  );
}

function table({ rows, count }: Comparison, { robot }: Context, store: Store): HTMLElement[] {
  if (rows.length === 0) return [element("p", { class: "note" }, words.noDifference)];
  const heads = [words.blockColumns.line, words.before, words.after, words.difference];
  const body = element("tbody", {}, ...rows.map(createRow));
  makeRows(body, (index) => {
    const { file, line, change } = rows[index];
    if (change === "gone" || !robot) return;
    const [block] = robot.blocks.blocksOfLine(robot.files.indexOf(file), line);
    if (block === undefined) goTo(store, { file, line }, null);
    else goToBlock(store, block);
  });
  initializeTabStops(body);
  return [
    element("p", { class: "note" }, words.compareCount(rows.length, count)),
    element(
      "table",
      { class: "differences" },
      element("caption", { class: "unseen" }, words.compareCaption),
      element("thead", {}, element("tr", {}, ...heads.map((name) => element("th", { scope: "col" }, name)))),
      body,
    ),
  ];
}

function createRow({ change, file, line, text, before_s, after_s }: Row): HTMLElement {
  const difference_s = after_s - before_s;
  return element(
    "tr",
    { class: change, title: `${file}: ${text}` },
    element("td", {}, `${line} `, element("small", {}, words.changes[change])),
    element("td", {}, change === "new" ? "–" : timeText(before_s)),
    element("td", {}, change === "gone" ? "–" : timeText(after_s)),
    element("td", { class: difference_s < 0 ? "faster" : "slower" }, signedTime(difference_s)),
  );
}

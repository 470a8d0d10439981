// Blocks of two runs with different times, in a table.

import { element } from "../../core/dom";
import { timeText } from "../../core/units";
import { texts } from "../../texts";
import { initializeTabStops, makeRows } from "../results/rows";
import type { Differences, Row } from "./data/differences";
import { limitInRun, passText } from "./comparison_messages";
import { signedTime } from "./variant_texts";

const words = texts.variants;

export class DifferenceRows {
  readonly element: HTMLElement;
  private readonly head = element("tr");
  private readonly body = element("tbody");
  private rows: Row[] = [];

  /** `choose` gets the blocks of a row, by number in each run; -1: none. */
  constructor(choose: (a: number, b: number) => void) {
    const caption = element("caption", { class: "unseen" }, words.rows);
    this.element = element("table", { class: "differences" }, caption, element("thead", {}, this.head), this.body);
    makeRows(this.body, (index) => choose(...this.rows[index].blocks));
  }

  show(rows: Row[], differences: Differences, names: readonly [string, string]): void {
    this.rows = rows;
    const heads = [words.rowColumns.line, ...names, words.rowColumns.difference];
    this.head.replaceChildren(...heads.map((name) => element("th", { scope: "col" }, name)));
    this.body.replaceChildren(...rows.map((row) => createRow(row, differences)));
    this.element.hidden = rows.length === 0;
    initializeTabStops(this.body);
  }
}

function createRow(row: Row, differences: Differences): HTMLElement {
  const { kind, file, line, text, blocks, times_s } = row;
  const difference_s = times_s[1] - times_s[0];
  const time = (side: 0 | 1) =>
    element("td", {}, blocks[side] < 0 ? "–" : timeText(times_s[side]), element("small", {}, limitInRun(differences, side, blocks[side])));
  return element(
    "tr",
    { class: kind, title: `${file}: ${text}` },
    element("td", {}, `${line} `, element("small", {}, `${words.kinds[kind]}${passText(row)}`.replace(/^, /, ""))),
    time(0),
    time(1),
    element("td", { class: difference_s < 0 ? "faster" : "slower" }, signedTime(difference_s)),
  );
}

// Variants in a table: the time of each, and the result.

import { element } from "../../core/dom";
import { texts } from "../../texts";
import { initializeTabStops, makeRows } from "../results/rows";
import { isCurrent, type VariantStatus } from "./data/results";
import type { Variant } from "./data/variants_file";
import { countedTime_s, signedTime, statusText, runTime, variantText } from "./variant_texts";

const words = texts.variants;

export interface ListedVariant {
  variant: Variant;
  standing: VariantStatus;
}

export interface ListEvents {
  choose(row: number): void;
  remove(row: number): void;
}

export class VariantList {
  readonly element: HTMLElement;
  private readonly body = element("tbody");

  constructor(events: ListEvents) {
    const heads = Object.values(words.columns).map((name) => element("th", { scope: "col" }, name));
    const head = element("thead", {}, element("tr", {}, ...heads));
    this.element = element("table", { class: "variant-list" }, element("caption", { class: "unseen" }, words.table), head, this.body);
    makeRows(this.body, (row) => events.choose(row), { Delete: (row) => events.remove(row) });
  }

  show(all: readonly ListedVariant[], chosen: number, robot: number): void {
    const hadFocus = this.body.contains(document.activeElement);
    this.body.replaceChildren(...all.map((each, i) => this.row(each, all[0], i === chosen, robot)));
    this.element.hidden = all.length === 0;
    initializeTabStops(this.body);
    const rows = [...this.body.children] as HTMLElement[];
    if (rows[chosen]) rows.forEach((row, i) => (row.tabIndex = i === chosen ? 0 : -1));
    if (hadFocus) rows[chosen]?.focus();
  }

  private row({ variant, standing }: ListedVariant, first: ListedVariant, isSelected: boolean, robot: number): HTMLElement {
    const [text, severity] = statusText(standing);
    const { setup, from, name } = variant;
    const [time, timeNote] = isCurrent(standing) ? runTime(standing.run, from, robot, standing.is === "stopped") : ["–", ""];
    return element(
      "tr",
      { "aria-selected": String(isSelected), class: standing.is },
      element("td", { class: "name", title: setup.program }, name, element("small", {}, variantText(variant, first.variant))),
      element("td", { class: "time" }, time, element("small", {}, timeNote)),
      element("td", { class: "difference" }, differenceFromFirst({ variant, standing }, first, robot)),
      element("td", { class: `standing ${severity}` }, text),
    );
  }
}

/** Returns the difference only if both came to their ends and count from the same position. */
function differenceFromFirst(one: ListedVariant, first: ListedVariant, robot: number): string {
  if (one.variant === first.variant || one.standing.is !== "done" || first.standing.is !== "done") return "";
  const { from } = one.variant;
  const [time_s, first_s] = [one, first].map(({ standing }) => countedTime_s(standing.run!, from, robot));
  return time_s === null || first_s === null ? "" : signedTime(time_s - first_s);
}

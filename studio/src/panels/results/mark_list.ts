// List of marks with position and time; a click on one jumps to it.

import { element } from "../../core/dom";
import { goTo } from "../../core/navigation";
import { markText } from "../../core/display_names";
import type { Store } from "../../core/store";
import { countText, timeText } from "../../core/units";
import type { Mark } from "../../run/marks";
import { texts } from "../../texts";
import { initializeTabStops, makeRows } from "./rows";

const words = texts.panels;

export interface Item {
  kind: string;
  text: string;
  title: string;
  /** "line 12", "1:02.3" */
  place: string;
  choose(): void;
}

export const markItem = (mark: Mark, store: Store): Item => ({
  kind: mark.kind,
  text: markText(mark, store.get("units")),
  title: mark.file ?? "",
  place: [timeText(mark.t_s, 2), ...(mark.line === null ? [] : [texts.run.line(mark.line)])].join(" · "),
  choose: () => goTo(store, mark, mark.t_s),
});

const createRow = (item: Item): HTMLElement =>
  element(
    "li",
    { role: "option", "aria-selected": "false", title: item.title, class: `mark ${item.kind}` },
    element("span", { class: "mark-place" }, item.place),
    element("span", { class: "mark-text" }, item.text),
  );

/** Creates a list of the first items, and a button for more. */
export function itemList(label: string, items: Item[], first: number): HTMLElement {
  const list = element("ul", { class: "rows", role: "listbox", "aria-label": label });
  const more = element("button", { class: "more", onclick: () => show(list.childElementCount + 10 * first) });
  const show = (count: number) => {
    list.append(...items.slice(list.childElementCount, count).map(createRow));
    initializeTabStops(list);
    more.hidden = list.childElementCount >= items.length;
    more.textContent = words.more(Math.min(items.length - list.childElementCount, 10 * first));
  };
  makeRows(list, (row) => {
    for (const each of list.children) each.setAttribute("aria-selected", "false");
    list.children[row].setAttribute("aria-selected", "true");
    items[row].choose();
  });
  show(first);
  return element("div", {}, list, more);
}

const INITIAL_ITEMS = 8;

/** Creates a list below a heading with the number of items. */
export const section = (title: string, kind: string, items: Item[]): HTMLElement =>
  element(
    "section",
    {},
    element("h3", { class: `heading ${kind}` }, `${title} `, element("small", {}, countText(items.length))),
    itemList(title, items, INITIAL_ITEMS),
  );

// Table with a row for each axis; a click on one jumps to the source of its value.

import { element } from "../../../core/dom";
import { goTo } from "../../../core/navigation";
import type { Store } from "../../../core/store";
import type { LocatedEntry } from "../../../run/report";
import { texts } from "../../../texts";
import { initializeTabStops, makeRows } from "../rows";

export interface AxisRow extends LocatedEntry {
  axis: string;
  t_s: number;
  cells: (Node | string)[];
  title: string;
  /** True if it exceeds the capability of the axis. */
  isOutOfRange: boolean;
}

export function axisTable(heads: readonly string[], rows: readonly AxisRow[], store: Store): HTMLElement {
  const head = element("tr", {}, ...heads.map((name) => element("th", { scope: "col" }, name)));
  const body = element("tbody", {}, ...rows.map(createRow));
  makeRows(body, (row) => {
    for (const each of body.children) each.setAttribute("aria-selected", "false");
    body.children[row].setAttribute("aria-selected", "true");
    goTo(store, rows[row], rows[row].t_s);
  });
  initializeTabStops(body);
  return element("table", { class: "travel drives" }, element("thead", {}, head), body);
}

function createRow({ axis, line, cells, title, isOutOfRange }: AxisRow): HTMLElement {
  const place = line === null ? "–" : texts.run.line(line);
  return element(
    "tr",
    { class: isOutOfRange ? "beyond" : "", title, "aria-selected": "false" },
    element("th", { scope: "row" }, axis),
    ...cells.map((cell) => element("td", {}, cell)),
    element("td", {}, place),
  );
}

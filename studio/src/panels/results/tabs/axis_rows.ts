// Table with a row for each axis; a click on one jumps to the source of its value.

import { element } from "../../../core/dom";
import { goTo } from "../../../core/go";
import type { Store } from "../../../core/store";
import type { Placed } from "../../../run/report";
import { texts } from "../../../texts";
import { beginRows, makeRows } from "../rows";

export interface AxisRow extends Placed {
  axis: string;
  t_s: number;
  cells: (Node | string)[];
  title: string;
  /** True if it exceeds the capability of the axis. */
  isBeyond: boolean;
}

export function axisTable(heads: readonly string[], rows: readonly AxisRow[], store: Store): HTMLElement {
  const head = element("tr", {}, ...heads.map((name) => element("th", { scope: "col" }, name)));
  const body = element("tbody", {}, ...rows.map(rowOf));
  makeRows(body, (row) => {
    for (const each of body.children) each.setAttribute("aria-selected", "false");
    body.children[row].setAttribute("aria-selected", "true");
    goTo(store, rows[row], rows[row].t_s);
  });
  beginRows(body);
  return element("table", { class: "travel drives" }, element("thead", {}, head), body);
}

function rowOf({ axis, line, cells, title, isBeyond }: AxisRow): HTMLElement {
  const place = line === null ? "–" : texts.run.line(line);
  return element(
    "tr",
    { class: isBeyond ? "beyond" : "", title, "aria-selected": "false" },
    element("th", { scope: "row" }, axis),
    ...cells.map((cell) => element("td", {}, cell)),
    element("td", {}, place),
  );
}

// Travel of each axis, and its limits.

import { element } from "../../../core/dom";
import type { Report } from "../../../run/report";
import type { Axis } from "../../../run/scene";
import { texts } from "../../../texts";

const words = texts.panels;

type Bounds = NonNullable<Report["bounds"]>;
type FormatValue = (value: number, rotary: boolean) => string;

export function createTravel(axes: Axis[], bounds: Bounds, text: FormatValue): HTMLElement {
  const rows = axes.filter((axis) => bounds[axis.letter]).map((axis) => createRow(axis, bounds[axis.letter], text));
  const head = element("tr", {}, ...words.travelHeads.map((name) => element("th", { scope: "col" }, name)));
  return element(
    "section",
    {},
    element("h3", { class: "heading" }, words.travel),
    element("table", { class: "travel" }, element("thead", {}, head), element("tbody", {}, ...rows)),
  );
}

function createRow(axis: Axis, { min, max, limit_min, limit_max }: Bounds[string], text: FormatValue): HTMLElement {
  const beyond = (limit_min !== null && min < limit_min) || (limit_max !== null && max > limit_max);
  const end = (value: number | null) => (value === null ? words.noLimit : text(value, axis.rotary));
  const limits = limit_min === null && limit_max === null ? words.noLimit : `${end(limit_min)} … ${end(limit_max)}`;
  return element(
    "tr",
    { class: beyond ? "beyond" : "", title: beyond ? words.beyond : limits },
    element("th", { scope: "row" }, axis.letter),
    element("td", {}, text(min, axis.rotary)),
    element("td", {}, text(max, axis.rotary)),
    element("td", {}, gauge(min, max, limit_min, limit_max, limits)),
  );
}

/** Shows the travel between the limits; without limits, in words. */
function gauge(min: number, max: number, from: number | null, to: number | null, limits: string): HTMLElement {
  if (from === null || to === null || !(to > from)) return element("span", { class: "note" }, limits);
  const share = (value: number) => Math.min(Math.max((100 * (value - from)) / (to - from), 0), 100);
  const style = `left:${share(min)}%;width:${Math.max(share(max) - share(min), 1)}%`;
  return element("div", { class: "gauge", role: "img", "aria-label": limits }, element("i", { style }));
}

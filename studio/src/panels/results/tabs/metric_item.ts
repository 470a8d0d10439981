// Name with its value, in a list of them.

import { element } from "../../../core/dom";

export const metricItem = (name: string, value: string, title = ""): HTMLElement =>
  element("div", { class: "figure", title }, element("dt", {}, name), element("dd", {}, value));

// A name with its value, of a list of such.

import { element } from "../../../core/dom";

export const figure = (name: string, value: string, title = ""): HTMLElement =>
  element("div", { class: "figure", title }, element("dt", {}, name), element("dd", {}, value));

// Elements as core/dom makes them, with listeners by the name of their event: make("button", { click: run }, "Run").

import { element } from "./dom";

export { onTheme, themeColour } from "./theme";

type Attributes = Record<string, string | number | boolean | ((event: Event) => void)>;

export function make<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  attributes: Attributes = {},
  ...children: (Node | string | null)[]
): HTMLElementTagNameMap[K] {
  const named = Object.entries(attributes).map(([name, value]) => {
    return [typeof value === "function" ? `on${name}` : name, value];
  });
  return element(tag, Object.fromEntries(named), ...children.filter((child) => child !== null));
}

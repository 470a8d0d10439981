// Tabs: arrows move between them, the chosen one is shown.

import { element } from "../core/dom";

export interface Tabs<Name extends string> {
  bar: HTMLElement;
  panels: HTMLElement[];
  readonly chosen: Name;
  choose(name: Name): void;
}

/** Ids begin with `prefix`; `displayed` is called for each tab that becomes visible. */
export function createTabs<Name extends string>(
  label: string,
  titles: Record<Name, string>,
  contents: Record<Name, { element: HTMLElement }>,
  prefix: string,
  displayed: (name: Name) => void,
): Tabs<Name> {
  const names = Object.keys(titles) as Name[];
  let chosen = names[0];
  const tabs = names.map((name) =>
    element(
      "button",
      { role: "tab", id: `${prefix}-tab-${name}`, "aria-controls": `${prefix}-panel-${name}`, onclick: () => choose(name) },
      titles[name],
    ),
  );
  const panels = names.map((name) =>
    element(
      "div",
      { role: "tabpanel", id: `${prefix}-panel-${name}`, "aria-labelledby": `${prefix}-tab-${name}`, class: "panel" },
      contents[name].element,
    ),
  );
  const bar = element("div", { role: "tablist", "aria-label": label, class: "tab-bar" }, ...tabs);

  function choose(name: Name): void {
    chosen = name;
    names.forEach((each, i) => {
      tabs[i].setAttribute("aria-selected", String(each === name));
      tabs[i].tabIndex = each === name ? 0 : -1;
      panels[i].hidden = each !== name;
    });
    displayed(name);
  }

  bar.addEventListener("keydown", (event) => {
    const at = names.indexOf(chosen);
    const to = { ArrowRight: at + 1, ArrowLeft: at - 1, Home: 0, End: names.length - 1 }[event.key];
    if (to === undefined) return;
    event.preventDefault();
    const next = (to + names.length) % names.length;
    choose(names[next]);
    tabs[next].focus();
  });
  choose(chosen);
  return {
    bar,
    panels,
    get chosen() {
      return chosen;
    },
    choose,
  };
}

// Units, theme and help.

import { element } from "../core/dom";
import type { Store } from "../core/store";
import { texts } from "../texts";
import { showHelp } from "./help";

const t = texts.bar;

export function preferences(store: Store, isServed: boolean): HTMLElement {
  const button = (title: string, act: () => void) => element("button", { title, "aria-label": title, onclick: act });
  const units = button(t.unitsTitle, () => store.set("units", store.get("units") === "inch" ? "mm" : "inch"));
  const theme = button(t.themeTitle, () => store.set("theme", store.get("theme") === "dark" ? "light" : "dark"));
  const help = button(t.helpTitle, () => showHelp(isServed));
  help.textContent = "?";
  const show = (one: HTMLElement, text: string, pressed: boolean) => {
    one.textContent = text;
    one.setAttribute("aria-pressed", String(pressed));
  };
  store.watch(["units", "theme"], () => {
    const [inch, dark] = [store.get("units") === "inch", store.get("theme") === "dark"];
    show(units, inch ? "inch" : "mm", inch);
    show(theme, dark ? "☾" : "☀", dark);
  });
  return element("span", { class: "preferences" }, units, theme, help);
}

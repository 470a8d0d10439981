// Bar of a page with a finished run: its title, and preferences.

import "./bar.css";
import { element } from "../core/dom";
import type { Store } from "../core/store";
import { texts } from "../texts";
import { preferences } from "./preferences";

/** Creates the title of a page with a finished run, which replaces the choices. */
function createRunTitle(store: Store): HTMLElement {
  const host = element("span", { class: "of-run" });
  store.watch(["run"], () => {
    const report = store.get("run")?.report;
    host.textContent = report ? `${report.program} · ${report.machine ?? ""}` : "";
  });
  return host;
}

export function createViewerBar(host: HTMLElement, store: Store): void {
  host.append(element("strong", { class: "name" }, texts.page.title), createRunTitle(store), preferences(store, false));
}

// Side panel of the page: the results of a run, and the forms that change it.

import "./side.css";
import { element } from "../core/dom";
import type { Session } from "../core/session";
import type { Store } from "../core/store";
import { texts } from "../texts";
import { createData } from "./data";
import type { PanelForm } from "./form";
import { createMachineForm } from "./machine";
import { createPaths } from "./paths";
import { createResults } from "./results";
import { createTeach } from "./teach";
import { createVariants } from "./variants";
import { createTabs } from "./tab_bar";

export function createPanels(host: HTMLElement, store: Store, session: Session): void {
  const results = element("div", {});
  createResults(results, store);
  const forms: Record<keyof typeof texts.side.tabs, PanelForm> = {
    run: { element: results },
    data: createData(store, session),
    machine: createMachineForm(store, session),
    teach: createTeach(store, session),
    paths: createPaths(store, session),
    variants: createVariants(store, session),
  };
  let last: PanelForm | null = null;
  /** Scroll position of each form when it was left. */
  const scrollPositions_px = new Map<PanelForm, number>();
  const tabs = createTabs(texts.side.label, texts.side.tabs, forms, "side", (name) => {
    const next = forms[name];
    if (last && last !== next) {
      scrollPositions_px.set(last, host.scrollTop);
      last.onHidden?.();
      host.scrollTop = scrollPositions_px.get(next) ?? 0;
    }
    last = next;
    last.onDisplayed?.();
  });
  tabs.bar.classList.add("side-bar");
  store.on("form", (name) => {
    if (!name) return;
    tabs.choose(name as keyof typeof forms);
    store.set("form", "");
  });
  host.append(tabs.bar, ...tabs.panels);
}

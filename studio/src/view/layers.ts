// Visible layers: a list of switches under a button.

import { check, element } from "../core/dom";
import type { State, Store } from "../core/store";
import { texts } from "../texts";
import { icon } from "./icons";

type LayerKey = "showRapids" | "showDirections" | "showZones" | "showEnvelope" | "compare";
/** Of this view alone. */
export interface ViewLayers {
  machine: boolean;
  /** Objects of the cell: the workpiece, and its surroundings. */
  cell: boolean;
  grid: boolean;
  extents: boolean;
}

const words = texts.view;

export function createLayers(store: Store, own: ViewLayers, changed: () => void): HTMLElement {
  const list = element("div", { class: "list", role: "group", "aria-label": words.show });
  for (const name of Object.keys(own) as (keyof ViewLayers)[]) {
    const { row, box } = check(words.layers[name], (on) => {
      own[name] = on;
      changed();
    });
    box.checked = own[name];
    list.append(row);
  }
  for (const key of ["showRapids", "showDirections", "showZones", "showEnvelope", "compare"] as LayerKey[]) {
    const { row, box } = check(words.layers[key], (on) => store.set(key, on as State[LayerKey]));
    store.watch([key], () => (box.checked = store.get(key)));
    if (key === "compare") store.watch(["previous"], () => (box.disabled = store.get("previous") === null));
    list.append(row);
  }
  const summary = element("summary", { title: words.show, "aria-label": words.show }, icon("layers"));
  const details = element("details", { class: "layers" }, summary, list);
  details.addEventListener("keydown", (event) => {
    if (event.key !== "Escape" || !details.open) return;
    details.open = false;
    summary.focus();
    event.stopPropagation();
  });
  document.addEventListener("pointerdown", (event) => {
    if (!details.contains(event.target as Node)) details.open = false;
  });
  return details;
}

// Machine and cell: forms of their files.

import "./machine.css";
import { element } from "../../core/dom";
import type { Session } from "../../core/session";
import type { Store } from "../../core/store";
import { texts } from "../../texts";
import type { PanelForm } from "../form";
import { createTabs } from "../tab_bar";
import { createCell } from "./cell";
import { Edits } from "./file/edits";
import { Model } from "./file/model";
import type { Context } from "./form/context";
import { Keys } from "./form/key_schema";
import { tablesAt } from "./file/toml";
import { ItemSelection, type Item } from "./items/item_selection";
import { Handle } from "./items/handle";
import { createMachine } from "./machine";
import { CheckRunner } from "./sections/check_runner";

/** Returns the item of the files for a body in the view; null: none. */
function findItem(model: Model, name: string): Item | null {
  for (const [part, kind] of [["cell", "object"], ["cell", "shape"], ["machine", "shape"]] as const) {
    if (tablesAt(model.value(part), [kind]).some((table) => table.name === name)) return { part, kind, name };
  }
  return null;
}

export function createMachineForm(store: Store, session: Session): PanelForm {
  const model = new Model(store, session);
  const context: Context = { store, session, model, edits: new Edits(model), keys: new Keys(session) };
  const chosen = new ItemSelection();
  const handle = new Handle(context, chosen);
  const checking = new CheckRunner(context, (checked) => {
    machine.setDiagnostics(checked.errors);
    cell.setDiagnostics(checked.errors);
  });
  const machine = createMachine(context, chosen, checking.result);
  const cell = createCell(context, chosen);
  const tabs = createTabs(texts.machine.label, texts.machine.tabs, { machine, cell }, "machine-form", () => chosen.choose(null));
  const draw = () => {
    machine.draw();
    cell.draw();
    handle.draw();
    checking.refresh();
  };
  model.on(draw);
  store.on("units", draw);
  let isVisible = false;
  store.on("body", (name) => {
    if (!isVisible || !name) return;
    // Reset, so that the next click counts as a change.
    store.set("body", null);
    const item = findItem(model, name);
    if (!item) return;
    tabs.choose(item.part === "machine" ? "machine" : "cell");
    chosen.choose(item);
  });
  return {
    element: element("div", { class: "machine-form" }, tabs.bar, ...tabs.panels),
    onDisplayed: () => {
      isVisible = true;
      model.show(true);
    },
    onHidden: () => {
      isVisible = false;
      model.show(false);
      chosen.choose(null);
    },
  };
}


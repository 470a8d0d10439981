// Form of the machine's file.

import { arrange, element } from "../../core/dom";
import type { EngineDiagnostic } from "../../run/run";
import { texts } from "../../texts";
import { FileRow } from "./file_row";
import type { Context, Section } from "./form/context";
import type { ItemSelection } from "./items/item_selection";
import { createItemList } from "./items/list";
import { createPairs } from "./items/pairs";
import { createAxes } from "./sections/axes";
import type { CheckResult } from "./sections/check";
import { createController } from "./sections/controller";
import { createFrame, createTable } from "./sections/tables";
import { showWizard } from "./wizard/dialog";

const words = texts.machine;

/** Form that also shows the results of the check for its files. */
export interface FileForm extends Section {
  setDiagnostics(errors: EngineDiagnostic[]): void;
}

function joinSections(...sections: Section[]): Section {
  return {
    element: element("div", {}, ...sections.map((section) => section.element)),
    draw: () => sections.forEach((section) => section.draw()),
  };
}

async function createSections(context: Context, chosen: ItemSelection): Promise<[title: string, Section][]> {
  const [machineKeys, controllerKeys] = await Promise.all([context.keys.of("machine"), context.keys.of("controller")]);
  const table = (name: keyof typeof words.tables) => createTable(context, name, words.tables[name], machineKeys(name));
  return [
    [words.sections.axes, createAxes(context, { linear: machineKeys("axis", "linear"), rotary: machineKeys("axis", "rotary") })],
    [words.sections.limits, table("path")],
    [words.sections.controller, createController(context, controllerKeys)],
    [words.sections.general, joinSections(table("machine"), table("program"))],
    [words.sections.frames, joinSections(...(["base", "tool", "work"] as const).map((name) => createFrame(context, name)))],
    [words.sections.process, joinSections(table("process"), table("checks"), table("times"))],
    [words.sections.bodies, joinSections(createItemList(context, "machine", "shape", chosen), createPairs(context, "machine"))],
  ];
}

export function createMachine(context: Context, chosen: ItemSelection, check: CheckResult): FileForm {
  const row = new FileRow(context, "machine", element("button", { type: "button", onclick: () => showWizard(context) }, words.wizard.open));
  const host = element("div", { class: "sections" });
  let sections: [string, Section][] = [];
  let made: Promise<void> | null = null;
  const make = async () => {
    sections = await createSections(context, chosen);
    const all = [...sections, [words.sections.check, check] as const];
    arrange(host, all.map(([title, section], i) => element("details", { class: "section", open: i === 0 }, element("summary", {}, title), section.element)));
    draw();
  };
  const draw = () => {
    row.draw();
    const { value } = context.model.parts.get("machine") ?? { value: null };
    // Text that is not valid TOML has nothing to show.
    host.hidden = value === null;
    if (value !== null) for (const [, section] of sections) section.draw();
  };
  return {
    element: element("div", {}, row.element, host),
    draw() {
      made ??= make();
      draw();
    },
    setDiagnostics: (errors) => row.setDiagnostics(errors),
  };
}

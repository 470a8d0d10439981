// Form of the machine's file.

import { arrange, element } from "../../core/dom";
import type { Told } from "../../run/run";
import { texts } from "../../texts";
import { FileRow } from "./file_row";
import type { Context, Section } from "./form/context";
import type { Chosen } from "./items/chosen";
import { createItems } from "./items/list";
import { createPairs } from "./items/pairs";
import { createAxes } from "./sections/axes";
import type { CheckResult } from "./sections/check";
import { createController } from "./sections/controller";
import { createFrame, createTable } from "./sections/tables";
import { showWizard } from "./wizard/dialog";

const words = texts.machine;

/** Form that also shows the results of the check for its files. */
export interface FileForm extends Section {
  told(faults: Told[]): void;
}

function together(...sections: Section[]): Section {
  return {
    element: element("div", {}, ...sections.map((section) => section.element)),
    draw: () => sections.forEach((section) => section.draw()),
  };
}

async function sectionsOf(context: Context, chosen: Chosen): Promise<[title: string, Section][]> {
  const [ofMachine, ofController] = await Promise.all([context.keys.of("machine"), context.keys.of("controller")]);
  const table = (name: keyof typeof words.tables) => createTable(context, name, words.tables[name], ofMachine(name));
  return [
    [words.sections.axes, createAxes(context, { linear: ofMachine("axis", "linear"), rotary: ofMachine("axis", "rotary") })],
    [words.sections.limits, table("path")],
    [words.sections.controller, createController(context, ofController)],
    [words.sections.general, together(table("machine"), table("program"))],
    [words.sections.frames, together(...(["base", "tool", "work"] as const).map((name) => createFrame(context, name)))],
    [words.sections.process, together(table("process"), table("checks"), table("times"))],
    [words.sections.bodies, together(createItems(context, "machine", "shape", chosen), createPairs(context, "machine"))],
  ];
}

export function createMachine(context: Context, chosen: Chosen, check: CheckResult): FileForm {
  const row = new FileRow(context, "machine", element("button", { type: "button", onclick: () => showWizard(context) }, words.wizard.open));
  const host = element("div", { class: "sections" });
  let sections: [string, Section][] = [];
  let made: Promise<void> | null = null;
  const make = async () => {
    sections = await sectionsOf(context, chosen);
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
    told: (faults) => row.tell(faults),
  };
}

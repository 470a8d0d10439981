// Program and machine: the choices in the bar, and the rarer ones in "More". Each is created once and follows
// the setup.

import { Debounced } from "../core/debounced";
import type { Documents } from "../core/documents";
import { choice, element, setOptions } from "../core/dom";
import { dialectTitles } from "../core/dialects";
import { dialectOfName, namesOfKind, shortName, type FileKind } from "../core/file_kinds";
import { controllerNames } from "../core/controller_override";
import type { Session } from "../core/session";
import { MAX_OVERRIDE_PERCENT, emptySetup, overrideKeys, type Setup } from "../core/setup";
import { texts } from "../texts";

const t = texts.bar;

/** Control of a part of the setup, with its update function. */
interface SetupControl {
  element: HTMLElement;
  refresh(): void;
}

/** Applies a choice of the user as an undoable step; `label` describes it. */
function choose(session: Session, label: string, setup: Partial<Setup>): void {
  session.history.edit(label, { setup });
  if (session.setup.program) void session.run();
}

const createLabelled = (label: string, control: HTMLElement): HTMLElement =>
  element("label", {}, element("span", {}, label), control);

/** Mark after a name in choices. */
export type MarkFunction = (name: string) => string;

/** Creates a file choice. `none` is its label without a file; null: a file is required. */
function fileChoice(label: string, key: FileKind & keyof Setup, none: string | null, session: Session, mark: MarkFunction): SetupControl {
  const select = choice(label, [], "", (name) => {
    // A program defines its language by its name; settings for the previous program do not apply to it.
    const setup = key === "program" ? { program: name, dialect: dialectOfName(name), robots: "" } : { [key]: name };
    choose(session, t.chosen(label, name ? shortName(name) : (none ?? "")), setup);
  });
  const refresh = () => {
    const value = session.setup[key];
    const names = namesOfKind(key, session.documents);
    // A set value is shown even if its file no longer exists here.
    if (value && !names.includes(value)) names.push(value);
    const options = names.map((name): [string, string] => {
      // Another file may have the same short name as a sample.
      const displayed = names.includes(shortName(name)) ? name : shortName(name);
      return [name, `${displayed} ${mark(name)}`.trim()];
    });
    setOptions(select, none !== null || !value ? [["", none ?? ""], ...options] : options, value);
  };
  return { element: createLabelled(label, select), refresh };
}

function createDialectChoice(session: Session): SetupControl {
  const options: [string, string][] = [["", t.fromMachineFile], ...Object.entries(dialectTitles)];
  const select = choice(t.language, options, "", (dialect) =>
    choose(session, t.chosen(t.language, dialectTitles[dialect] ?? t.fromMachineFile), { dialect }),
  );
  return { element: createLabelled(t.language, select), refresh: () => setOptions(select, options, session.setup.dialect) };
}

/** Creates the choice of a controller instead of the machine file's: a built-in one, or a file. */
function createControllerChoice(session: Session): SetupControl {
  const select = choice(t.control, [], "", (controller) =>
    choose(session, t.chosen(t.control, controller ? shortName(controller) : t.fromMachineFile), { controller }),
  );
  const refresh = () => {
    const { controller } = session.setup;
    const names = controllerNames(session.documents);
    if (controller && !names.includes(controller)) names.push(controller);
    setOptions(select, [["", t.fromMachineFile], ...names.map((name): [string, string] => [name, shortName(name)])], controller);
  };
  return { element: createLabelled(t.control, select), refresh };
}

function override(key: (typeof overrideKeys)[number], session: Session): SetupControl {
  const label = t.overrides[key];
  const input = element("input", {
    type: "number",
    min: 0,
    max: MAX_OVERRIDE_PERCENT,
    step: 5,
    onchange: () => {
      const percent = Math.min(MAX_OVERRIDE_PERCENT, Math.max(0, Number(input.value) || 0));
      choose(session, t.chosen(label, String(percent)), { [key]: percent });
      refresh();
    },
  });
  const refresh = () => (input.value = String(session.setup[key]));
  return { element: createLabelled(label, input), refresh };
}

function collisions(session: Session): SetupControl {
  const input = element("input", {
    type: "checkbox",
    onchange: () => choose(session, t.chosen(t.collisions, input.checked ? t.yes : t.no), { collisions: input.checked }),
  });
  const row = element("label", {}, input, element("span", {}, t.collisions));
  return { element: row, refresh: () => (input.checked = session.setup.collisions) };
}

/**
 * Counts the settings in "More" that are not at their defaults, because hidden settings have an effect, too.
 */
function countChangedSettings(setup: Readonly<Setup>): number {
  const first = emptySetup();
  const hidden = ["dialect", "controller", "machine_data", "robots", ...overrideKeys, "collisions"] as const;
  return hidden.filter((key) => setup[key] !== first[key]).length;
}

/** Creates an element that opens below its label, until Escape or a click elsewhere. */
function createMoreSection(summary: HTMLElement, ...content: HTMLElement[]): HTMLElement {
  const details = element("details", {}, summary, element("div", {}, ...content));
  document.addEventListener("keydown", (event) => {
    if (event.key !== "Escape" || event.defaultPrevented || !details.open) return;
    if (details.contains(document.activeElement)) summary.focus();
    details.open = false;
  });
  document.addEventListener("pointerdown", (event) => {
    if (!details.contains(event.target as Node)) details.open = false;
  });
  return details;
}

/** Returns true if a name is correctly listed in the choices: changes within a file do not affect them. */
const isListed = (host: HTMLElement, name: string, documents: Documents): boolean =>
  documents.get(name) !== undefined && host.querySelector(`option[value="${CSS.escape(name)}"]`) !== null;

export interface Choices {
  element: HTMLElement;
  /** Soon, once for many calls. */
  refresh(): void;
}

export function createChoices(session: Session, mark: MarkFunction): Choices {
  const main = [
    fileChoice(t.program, "program", null, session, mark),
    fileChoice(t.machine, "machine", t.builtInMachine, session, mark),
    fileChoice(t.cell, "cell", t.noCell, session, mark),
  ];
  const rareChoices = [
    createDialectChoice(session),
    createControllerChoice(session),
    fileChoice(t.machineData, "machine_data", t.none, session, mark),
    fileChoice(t.robots, "robots", t.none, session, mark),
    ...overrideKeys.map((key) => override(key, session)),
    collisions(session),
  ];
  const elements = (choices: SetupControl[]) => choices.map((each) => each.element);
  const summary = element("summary", {});
  const host = element("span", { class: "choices" }, ...elements(main), createMoreSection(summary, ...elements(rareChoices)));
  const refresh = () => {
    for (const each of [...main, ...rareChoices]) each.refresh();
    summary.textContent = t.changed(countChangedSettings(session.setup));
  };
  const redrawTimer = new Debounced(refresh);
  session.on(refresh);
  session.documents.on((name) => {
    if (!isListed(host, name, session.documents)) redrawTimer.after(0);
  });
  refresh();
  return { element: host, refresh: () => redrawTimer.after(0) };
}

// What is run on what: the choices in the bar, and the rarer ones behind "More".

import type { Documents } from "../core/documents";
import { choice, element } from "../core/dom";
import { dialectOfName, kindOfFile, type FileKind } from "../core/kinds";
import type { Session, Setup } from "../core/session";
import { texts } from "../texts";

const t = texts.bar;

/** Names of documents of a kind, own ones first. */
function namesOf(kind: FileKind, documents: Documents): string[] {
  const all = [...documents.ownNames(), ...[...documents.samples.keys()].filter((name) => !documents.isOwn(name))];
  return all.filter((name) => kindOfFile(name, documents.get(name) ?? "") === kind);
}

const shown = (name: string): string => name.replace(/^samples\/(machines|cell)\//, "").replace(/^samples\//, "");

function fileChoice(label: string, key: keyof Setup, kind: FileKind, none: string | null, session: Session): HTMLElement {
  const names = namesOf(kind, session.documents);
  const value = session.setup[key] as string;
  const options: [string, string][] = names.map((name) => [name, shown(name)]);
  if (none !== null) options.unshift(["", none]);
  const select = choice(label, options, value, (name) => {
    // A program brings its language along, by its name; what the one before needed is not its.
    session.change(key === "program" ? { program: name, dialect: dialectOfName(name), robots: "" } : { [key]: name });
    if (session.setup.program) void session.run();
  });
  return element("label", {}, element("span", {}, label), select);
}

function dialectChoice(session: Session): HTMLElement {
  const options: [string, string][] = [
    ["", t.asTheMachineSays],
    ["ab9", "Allen-Bradley 9/Series"],
    ["rs274ngc", "RS274/NGC (LinuxCNC)"],
  ];
  const select = choice(t.language, options, session.setup.dialect, (dialect) => {
    session.change({ dialect });
    void session.run();
  });
  return element("label", {}, element("span", {}, t.language), select);
}

export function mainChoices(session: Session): HTMLElement[] {
  return [
    fileChoice(t.program, "program", "program", session.setup.program ? null : "", session),
    fileChoice(t.machine, "machine", "machine", t.builtInMachine, session),
    fileChoice(t.cell, "cell", "cell", t.noCell, session),
  ];
}

function feedOverride(session: Session): HTMLElement {
  const input = element("input", {
    type: "number",
    min: 0,
    max: 1000,
    step: 5,
    value: session.setup.feed_override_percent,
    onchange: () => {
      const percent = Math.min(1000, Math.max(0, Number(input.value) || 0));
      session.change({ feed_override_percent: percent });
      void session.run();
    },
  });
  return element("label", {}, element("span", {}, t.feedOverride), input);
}

function collisions(session: Session): HTMLElement {
  const input = element("input", {
    type: "checkbox",
    checked: session.setup.collisions,
    onchange: () => {
      session.change({ collisions: input.checked });
      void session.run();
    },
  });
  return element("label", {}, input, element("span", {}, t.collisions));
}

export function moreChoices(session: Session): HTMLElement[] {
  return [
    dialectChoice(session),
    fileChoice(t.machineData, "machine_data", "machine_data", t.none, session),
    fileChoice(t.robots, "robots", "robots", t.none, session),
    feedOverride(session),
    collisions(session),
  ];
}

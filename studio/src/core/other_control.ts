// A machine with another control than its file names: the file's text with that model in place of its table of the
// controller, so that nothing of the one control stays in the other.

import { texts } from "../texts";
import type { Documents } from "./documents";
import { faultsOf } from "./faults";
import { isFile, referenceTo } from "./references";
import type { Answered } from "./answered";
import type { Setup } from "./setup";

/** The sample that is compiled in, and taken where no machine is named. */
export const BUILT_IN_MACHINE = "samples/machines/af5.toml";
const BUILT_IN_CONTROL = /^samples\/controllers\/(.+)\.toml$/;

type Ask = (request: Record<string, unknown>) => Promise<Answered>;

/** A machine file's name and its text; or why there is none. */
export type OtherControl = { machine: string; text: string } | { refusal: string };

const isController = (text: string): boolean => /^\s*\[controller\]/m.test(text) && !/^\s*\[\[axis\]\]/m.test(text);

/** Controls that are built in, by name, and files of one's own. */
export function controlNames(documents: Documents): string[] {
  const builtIn = [...documents.samples.keys()].flatMap((name) => BUILT_IN_CONTROL.exec(name)?.[1] ?? []);
  const own = documents.ownNames().filter((name) => isFile(name) && isController(documents.text(name)));
  return [...builtIn, ...own];
}

async function changed(ask: Ask, file: string, changes: unknown[]): Promise<{ value: Record<string, unknown>; text: string } | string> {
  const answer = await ask({ do: "toml", file, changes });
  const found = answer.messages.find(({ is }) => is === "toml");
  if (!answer.ok || !found) return faultsOf(answer)[0]?.text ?? answer.message;
  const text = new TextDecoder().decode(found.columns.get("text") as Uint8Array);
  return { value: found.header.value as Record<string, unknown>, text };
}

/** Of a set-up that names a controller. */
export async function withOtherControl(setup: Readonly<Setup>, ask: Ask): Promise<OtherControl> {
  const { controller, robots, cell } = setup;
  if (robots) return { refusal: texts.run.controlOfRobots };
  if (!setup.machine && cell) return { refusal: texts.run.controlOfCell };
  const machine = setup.machine || BUILT_IN_MACHINE;
  const asIs = await changed(ask, machine, []);
  if (typeof asIs === "string") return { refusal: asIs };
  const model = isFile(controller) ? referenceTo(machine, controller) : controller;
  const away = asIs.value.controller === undefined ? [] : [{ op: "remove", at: ["controller"] }];
  const made = await changed(ask, machine, [...away, { op: "set", at: ["controller", "model"], value: model }]);
  return typeof made === "string" ? { refusal: made } : { machine, text: made.text };
}

// Machine with another controller than its file names. The file's text gets that model instead of its
// controller table, so that no setting of the one controller stays in the other.

import { texts } from "../texts";
import type { Documents } from "./documents";
import { faultsOf } from "./faults";
import { isFile, referenceTo } from "./references";
import type { Answered } from "./answered";
import type { Setup } from "./setup";

/** Compiled-in sample, used if no machine is named. */
export const BUILT_IN_MACHINE = "samples/machines/af5.toml";
const BUILT_IN_CONTROL = /^samples\/controllers\/(.+)\.toml$/;

type Ask = (request: Record<string, unknown>) => Promise<Answered>;

/** Name of a machine file with its text, or the reason why it does not exist. */
export type OtherControl = { machine: string; text: string } | { refusal: string };

const isController = (text: string): boolean => /^\s*\[controller\]/m.test(text) && !/^\s*\[\[axis\]\]/m.test(text);

/** Returns built-in controllers, by name, and files of the user. */
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

/** Returns the machine for a setup that names a controller. */
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

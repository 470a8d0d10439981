// Machine with another controller than its file names. The file's text gets that model instead of its
// controller table, so that no setting of the one controller stays in the other.

import { texts } from "../texts";
import type { Documents } from "./documents";
import { responseDiagnostics } from "./response_diagnostics";
import { isTomlFile, referenceTo } from "./references";
import type { EngineResponse } from "./engine_response";
import type { Setup } from "./setup";

/** Compiled-in sample, used if no machine is named. */
export const BUILT_IN_MACHINE = "samples/machines/af5.toml";
const BUILT_IN_CONTROLLER = /^samples\/controllers\/(.+)\.toml$/;

type SendRequest = (request: Record<string, unknown>) => Promise<EngineResponse>;

/** Name of a machine file with its text, or the reason why it does not exist. */
export type ControllerOverride = { machine: string; text: string } | { refusal: string };

const isController = (text: string): boolean => /^\s*\[controller\]/m.test(text) && !/^\s*\[\[axis\]\]/m.test(text);

/** Returns built-in controllers, by name, and files of the user. */
export function controllerNames(documents: Documents): string[] {
  const builtIn = [...documents.samples.keys()].flatMap((name) => BUILT_IN_CONTROLLER.exec(name)?.[1] ?? []);
  const own = documents.userFileNames().filter((name) => isTomlFile(name) && isController(documents.text(name)));
  return [...builtIn, ...own];
}

async function changed(ask: SendRequest, file: string, changes: unknown[]): Promise<{ value: Record<string, unknown>; text: string } | string> {
  const response = await ask({ do: "toml", file, changes });
  const found = response.messages.find(({ is }) => is === "toml");
  if (!response.ok || !found) return responseDiagnostics(response)[0]?.text ?? response.message;
  const text = new TextDecoder().decode(found.columns.get("text") as Uint8Array);
  return { value: found.header.value as Record<string, unknown>, text };
}

/** Returns the machine for a setup that names a controller. */
export async function overrideController(setup: Readonly<Setup>, ask: SendRequest): Promise<ControllerOverride> {
  const { controller, robots, cell } = setup;
  if (robots) return { refusal: texts.run.controlOfRobots };
  if (!setup.machine && cell) return { refusal: texts.run.controlOfCell };
  const machine = setup.machine || BUILT_IN_MACHINE;
  const unchanged = await changed(ask, machine, []);
  if (typeof unchanged === "string") return { refusal: unchanged };
  const model = isTomlFile(controller) ? referenceTo(machine, controller) : controller;
  const away = unchanged.value.controller === undefined ? [] : [{ op: "remove", at: ["controller"] }];
  const made = await changed(ask, machine, [...away, { op: "set", at: ["controller", "model"], value: model }]);
  return typeof made === "string" ? { refusal: made } : { machine, text: made.text };
}

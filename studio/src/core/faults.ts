// Errors of files that are no programs, from the engine's response.

import type { Told } from "../run/run";
import type { Answered } from "./answered";

/** "my.toml:12:1: unknown key 'max'" */
const PLACED = /^(.+?):(\d+):(\d+): ([\s\S]*)$/;

function toldOfFailure(code: string, message: string): Told {
  const [, file, line, column, text] = PLACED.exec(message) ?? [];
  const place = { file: file ?? "", line: Number(line ?? 0), column: Number(column ?? 0), end_column: 0 };
  return { severity: "error", code, ...place, text: text ?? message, hint: "" };
}

/** Returns all diagnostics, and the reason of the failure, if that has not been reported already. */
export function faultsOf({ ok, code, message, messages }: Answered): Told[] {
  const told = messages.filter(({ is }) => is === "told").map(({ header }) => header as unknown as Told);
  if (ok || code === "cancelled") return told;
  const last = toldOfFailure(code, message);
  return told.some(({ severity, text }) => severity === "error" && last.text.includes(text)) ? told : [...told, last];
}

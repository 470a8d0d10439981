// Errors of files that are no programs, from the engine's response.

import type { EngineDiagnostic } from "../run/run";
import type { EngineResponse } from "./engine_response";

/** "my.toml:12:1: unknown key 'max'" */
const LOCATED_MESSAGE = /^(.+?):(\d+):(\d+): ([\s\S]*)$/;

function failureDiagnostic(code: string, message: string): EngineDiagnostic {
  const [, file, line, column, text] = LOCATED_MESSAGE.exec(message) ?? [];
  const place = { file: file ?? "", line: Number(line ?? 0), column: Number(column ?? 0), end_column: 0 };
  return { severity: "error", code, ...place, text: text ?? message, hint: "" };
}

/** Returns all diagnostics, and the reason of the failure, if that has not been reported already. */
export function responseDiagnostics({ ok, code, message, messages }: EngineResponse): EngineDiagnostic[] {
  const diagnostics = messages.filter(({ is }) => is === "diagnostic").map(({ header }) => header as unknown as EngineDiagnostic);
  if (ok || code === "cancelled") return diagnostics;
  const last = failureDiagnostic(code, message);
  return diagnostics.some(({ severity, text }) => severity === "error" && last.text.includes(text)) ? diagnostics : [...diagnostics, last];
}

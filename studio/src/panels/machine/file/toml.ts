// TOML document as the engine reads and changes it; comments and order are kept.

import type { FileContent } from "../../../core/file_content";
import { responseDiagnostics } from "../../../core/response_diagnostics";
import type { Session } from "../../../core/session";
import type { EngineDiagnostic } from "../../../run/run";

export type Toml = string | number | boolean | null | Toml[] | TomlTable;
export interface TomlTable {
  [key: string]: Toml;
}

/** Position of a value: keys of tables and numbers of elements, from 0. */
export type TomlPath = (string | number)[];

export type TomlChange =
  | { op: "set"; at: TomlPath; value: Toml }
  | { op: "add"; at: TomlPath; value: Toml }
  | { op: "remove"; at: TomlPath }
  | { op: "move"; at: TomlPath; to: number };

export interface EditedToml {
  value: TomlTable;
  text: string;
}

/** Changed document, or the reason why it was not changed. */
export type TomlResult = { written: EditedToml; error: null } | { written: null; error: EngineDiagnostic };

/** Reads or changes a file; `content` is its text if it is not a document yet. */
export async function requestToml(session: Session, file: string, changes: TomlChange[], content?: FileContent): Promise<TomlResult> {
  const files = { [file]: content ?? session.documents.get(file) ?? "" };
  // The engine needs only this one of all documents.
  const response = await session.sendRequest({ do: "toml", file, changes }, files, new Map());
  const found = response.messages.find(({ is }) => is === "toml");
  if (!response.ok || !found) {
    const [error] = responseDiagnostics({ ...response, ok: false }).filter(({ severity }) => severity === "error");
    return { written: null, error };
  }
  const text = new TextDecoder().decode(found.columns.get("text") as Uint8Array);
  return { written: { value: found.header.value as TomlTable, text }, error: null };
}

/** Undefined: it is not there. */
export function valueAt(root: Toml | undefined, at: TomlPath): Toml | undefined {
  let value: Toml | undefined = root;
  for (const step of at) {
    if (value === null || typeof value !== "object") return undefined;
    value = (value as TomlTable)[step];
  }
  return value;
}

export const tableAt = (root: Toml | undefined, at: TomlPath): TomlTable => {
  const value = valueAt(root, at);
  return value !== null && typeof value === "object" && !Array.isArray(value) ? value : {};
};

/** Returns the tables of an array of tables. */
export const tablesAt = (root: Toml | undefined, at: TomlPath): TomlTable[] => {
  const value = valueAt(root, at);
  if (!Array.isArray(value)) return [];
  return value.map((each) => (each !== null && typeof each === "object" && !Array.isArray(each) ? each : {}));
};

export const textAt = (root: Toml | undefined, at: TomlPath): string => {
  const value = valueAt(root, at);
  return typeof value === "string" ? value : "";
};

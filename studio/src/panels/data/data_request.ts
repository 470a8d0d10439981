// Machine data as known to the engine (docs/studio.md): possible entries, existing entries, and their
// changes.

import type { Session } from "../../core/session";
import type { EngineDiagnostic } from "../../run/run";

export interface Field {
  name: string;
  unit: "length" | "angle" | "none";
  /** And what it may be. */
  meaning: string;
  required: boolean;
  /** Possible values; the first one applies by default. */
  choices?: string[];
}

export interface Section {
  /** "OFFSET" */
  name: string;
  title: string;
  /** What an id may be. */
  id: string;
  /** True if its entries have lengths, each in mm or inch. */
  has_unit: boolean;
  fields: Field[];
}

export type EntryUnit = "metric" | "inch";
export type Value = number | string | null | undefined;

export interface Entry {
  id: string;
  unit?: EntryUnit;
  /** Values by field name; null: no wall. */
  [field: string]: Value;
}

export type LengthUnit = "mm" | "inch";

export interface SetEntry {
  op: "set";
  section: string;
  id: string;
  values: Record<string, string>;
  unit?: LengthUnit;
}

export type DataChange =
  | SetEntry
  | { op: "reset"; section: string; id: string }
  | { op: "reset_all"; section: string }
  | { op: "convert"; unit: LengthUnit };

export interface Data {
  sections: Section[];
  entries: Record<string, Entry[] | undefined>;
  /** The file. */
  text: string;
}

/** The data, or the reason why they are missing; `diagnostics` has the warnings and errors. */
export type DataResult = { diagnostics: EngineDiagnostic[] } & ({ data: Data } | { data: null; refusal: string });

export const lengthUnit = (unit: EntryUnit): LengthUnit => (unit === "inch" ? "inch" : "mm");

/** Removes the file name from messages such as "jet.txt: 'a' is not a number", if the file is clear. */
const stripFileName = (sentence: string, file: string): string =>
  sentence.startsWith(`${file}: `) ? sentence.slice(file.length + 2) : sentence;

/** Returns the data of a file after some changes; new data if no file has the name. */
export async function requestData(session: Session, file: string, changes: DataChange[]): Promise<DataResult> {
  const { machine, cell } = session.setup;
  const response = await session.sendRequest({ do: "data", file, machine, cell, changes });
  const diagnostics = response.messages.filter(({ is }) => is === "diagnostic").map(({ header }) => header as unknown as EngineDiagnostic);
  const message = response.messages.find(({ is }) => is === "data");
  if (!response.ok || !message) return { diagnostics, data: null, refusal: stripFileName(response.message, file) };
  const { sections, entries } = message.header as unknown as Omit<Data, "text">;
  const text = new TextDecoder().decode(message.columns.get("text") as Uint8Array);
  return { diagnostics, data: { sections, entries, text } };
}

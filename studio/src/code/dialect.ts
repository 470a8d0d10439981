// Dialect for the editor: its codes and letters by name, and the dialect of a program.

import { defaultDialect, dialectOfController, dialectProperties, type DialectProperties } from "../core/dialects";
import { dialectOfName } from "../core/file_kinds";
import type { Code, Language } from "../core/languages";
import type { Session } from "../core/session";

/** Groups of codes that act only once, so that none of them stays active. */
const nonModalGroups = new Set(["program stop", "subprograms", "tool change", "inputs and outputs", "modal state"]);

export const isModal = (code: Code): boolean => code.group !== null && !nonModalGroups.has(code.group);

/** "g01" and "G 1" are G1, "G59.10" is G59.1. */
export const codeName = (letter: string, number: string): string => letter.toUpperCase() + String(Number(number));

export class Dialect {
  readonly codes = new Map<string, Code>();
  /** Codes by the name of the function in Lua. */
  readonly functions = new Map<string, Code>();
  readonly letters = new Map<string, string>();
  readonly axes = new Set<string>();
  readonly initial: readonly string[];
  /** "RS274/NGC" */
  readonly title: string;
  readonly properties: DialectProperties;

  /** `language` is null if the page has no engine: then codes are unknown. */
  constructor(
    readonly name: string,
    language: Language | null,
  ) {
    this.properties = dialectProperties(name);
    this.title = language?.title ?? (this.properties.title || name);
    for (const code of language?.codes ?? []) {
      this.codes.set(code.code, code);
      this.functions.set(code.lua, code);
    }
    for (const [keys, meaning] of Object.entries(language?.letters ?? {})) {
      for (const key of keys.split(" ")) {
        this.letters.set(key, meaning);
        if (meaning.startsWith("axes")) this.axes.add(key);
      }
    }
    if (!language) for (const axis of "XYZABCUVW") this.axes.add(axis);
    this.initial = (language?.initial ?? "").split(" ").filter((code) => code !== "");
  }

  /** Returns true if the tables have no such code, and users do not define it. */
  isUnknown(name: string): boolean {
    if (this.codes.size === 0 || this.codes.has(name)) return false;
    return !this.properties.userCodes?.test(name);
  }
}

/** Returns the dialect that the setup or its machine file sets; "": neither does. */
function configuredDialect(session: Session): string {
  const { dialect, machine } = session.setup;
  if (dialect) return dialectOfController(dialect);
  const said = machine && /^\s*dialect\s*=\s*["']([^"']+)["']/m.exec(session.documents.text(machine));
  return said ? dialectOfController(said[1]) : "";
}

/** Returns the dialect; if it is not set, the program's name decides. */
export function dialectName(session: Session, program: string): string {
  return configuredDialect(session) || (dialectOfName(program) || defaultDialect);
}

/**
 * Returns true if the engine would read the program in another dialect than it appears to be in: without a
 * setting it reads the default one.
 */
export function needsDialectSetting(session: Session, program: string): boolean {
  return configuredDialect(session) === "" && dialectName(session, program) !== defaultDialect;
}

// Possible keys in the tables of a file, as reported by the engine (docs/studio.md).

import type { Session } from "../../../core/session";
import type { Toml, TomlTable } from "../file/toml";

/** Range of numbers that a key accepts. */
export interface Range {
  min?: number;
  /** Lower limit that is itself excluded. */
  above?: number;
  max?: number;
  below?: number;
  /** Other values that it also accepts. */
  or?: (number | string)[];
  integer?: boolean;
}

export interface Key extends Range {
  name: string;
  kind: "number" | "text" | "switch" | "list" | "table";
  meaning: string;
  /** "mm/s2" */
  unit?: string;
  /** Of a list. */
  elements?: "number" | "text" | "list" | "table";
  default?: Toml;
  choices?: string[];
  /** True if other values than these choices are possible. */
  open?: boolean;
  required?: boolean;
  /** Its name before this version; the file may still have it. */
  formerly?: string;
  /** Pattern for all keys of this form. */
  pattern?: string;
}

/** Returns the name that a table has for a key. */
export const nameIn = (table: TomlTable, key: string, formerly?: string): string =>
  formerly !== undefined && table[key] === undefined && table[formerly] !== undefined ? formerly : key;

interface Table {
  /** Keys from the top of the document to the table. */
  at: string[];
  /** Condition, if tables of the same name have different keys. */
  where?: Record<string, string>;
  keys: Key[];
}

export type SchemaKind = "machine" | "controller";

export class Keys {
  private readonly known = new Map<SchemaKind, Promise<Table[]>>();

  constructor(private readonly session: Session) {}

  /**
   * Requests the keys once. The result finds the keys of a table by its position, "controller.stops", and by
   * its kind.
   */
  async of(file: SchemaKind): Promise<(at: string, kind?: string) => Key[]> {
    const asked = this.known.get(file) ?? this.ask(file);
    this.known.set(file, asked);
    const tables = await asked;
    return (at, kind) => {
      const isMatch = ({ at: steps, where }: Table) => steps.join(".") === at && (!where || !kind || Object.values(where).includes(kind));
      return tables.find(isMatch)?.keys ?? [];
    };
  }

  private async ask(file: SchemaKind): Promise<Table[]> {
    const { messages } = await this.session.sendRequest({ do: "keys", of: file }, {}, new Map());
    return (messages.find(({ is }) => is === "keys")?.header.tables ?? []) as Table[];
  }
}

// What may stand in the tables of a file: the engine tells it (docs/studio.md).

import type { Session } from "../../../core/session";
import type { Toml } from "../file/toml";

/** Which numbers a key takes. */
export interface Range {
  least?: number;
  /** The least itself is none of them. */
  above?: number;
  most?: number;
  below?: number;
  /** Others that it takes, too. */
  or?: (number | string)[];
  whole?: boolean;
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
  /** There are others than these choices. */
  open?: boolean;
  required?: boolean;
  /** It stands for all keys of this form. */
  pattern?: string;
}

interface Table {
  /** Its keys from the document on. */
  at: string[];
  /** Where others of the name have other keys. */
  where?: Record<string, string>;
  keys: Key[];
}

export type KeyedFile = "machine" | "controller";

export class Keys {
  private readonly known = new Map<KeyedFile, Promise<Table[]>>();

  constructor(private readonly session: Session) {}

  /** Asked for once. The answer finds the keys of a table by where it is, "controller.stops", and what kind of it is meant. */
  async of(file: KeyedFile): Promise<(at: string, kind?: string) => Key[]> {
    const asked = this.known.get(file) ?? this.ask(file);
    this.known.set(file, asked);
    const tables = await asked;
    return (at, kind) => {
      const isMeant = ({ at: steps, where }: Table) => steps.join(".") === at && (!where || !kind || Object.values(where).includes(kind));
      return tables.find(isMeant)?.keys ?? [];
    };
  }

  private async ask(file: KeyedFile): Promise<Table[]> {
    const { messages } = await this.session.question({ do: "keys", of: file }, {}, new Map());
    return (messages.find(({ is }) => is === "keys")?.header.tables ?? []) as Table[];
  }
}

// The two languages of part programs, from the tables that the translator runs by.

export interface Code {
  /** "G92.1" */
  code: string;
  /** The function in Lua: "G92_1". */
  lua: string;
  meaning: string;
  /** Modal group; null: it acts in its block alone. */
  group: string | null;
  /** Letters it takes besides axis words. */
  words: string;
  axes: boolean;
  supported: boolean;
}

export interface Language {
  name: string;
  title: string;
  /** Codes in force when a program begins, between blanks. */
  initial: string;
  letters: Record<string, string>;
  codes: Code[];
}

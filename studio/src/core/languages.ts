// Two languages of part programs, from the translator's tables.

export interface Code {
  /** "G92.1" */
  code: string;
  /** The function in Lua: "G92_1". */
  lua: string;
  meaning: string;
  /** Modal group; null: it acts only in its block. */
  group: string | null;
  /** Letters in addition to axis words. */
  words: string;
  axes: boolean;
  supported: boolean;
}

export interface Language {
  name: string;
  title: string;
  /** Active codes at the start of a program, separated by blanks. */
  initial: string;
  letters: Record<string, string>;
  codes: Code[];
}

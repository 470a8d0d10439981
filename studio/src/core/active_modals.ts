// Modal state at a line of a program, derived from its text.

export interface ActiveSettings {
  /** Modal codes with their groups and meanings. */
  codes: { name: string; group: string; meaning: string }[];
  /** "F600", "S12000" */
  words: string[];
  /** True if the text has subprograms, jumps or loops, so that it is less informative than a run. */
  jumps: boolean;
}

/** Function that returns the state when a line begins; null: unknown. */
export type QueryActiveModals = (file: string, line: number) => Promise<ActiveSettings | null>;

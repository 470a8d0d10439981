// What is in force at a line of a program, as the code knows it by the text.

export interface InForce {
  /** Modal codes with their groups and meanings. */
  codes: { name: string; group: string; meaning: string }[];
  /** "F600", "S12000" */
  words: string[];
  /** Whether there are subprograms, jumps or loops, so that the text says less than a run. */
  jumps: boolean;
}

/** When a line begins; null: nothing is known of it. */
export type TellInForce = (file: string, line: number) => Promise<InForce | null>;

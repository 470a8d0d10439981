// Inputs of a run.

/** Names of documents (empty: none) and the options of the operator. */
export interface Setup {
  program: string;
  /** Machine file; empty: the machine of the cell, or the built-in one. */
  machine: string;
  /** "ab9", "rs274ngc"; empty: as set by the machine file. */
  dialect: string;
  cell: string;
  machine_data: string;
  robots: string;
  /** Built-in model or file, in place of the controller of the machine file; empty: as set there. */
  controller: string;
  collisions: boolean;
  feed_override_percent: number;
  rapid_override_percent: number;
  spindle_override_percent: number;
}

export const emptySetup = (): Setup => ({
  program: "",
  machine: "",
  dialect: "",
  cell: "",
  machine_data: "",
  robots: "",
  controller: "",
  collisions: true,
  feed_override_percent: 100,
  rapid_override_percent: 100,
  spindle_override_percent: 100,
});

/** Keys of a setup that are names of documents. */
export const fileKeys = ["program", "machine", "cell", "machine_data", "robots"] as const;
export const overrideKeys = ["feed_override_percent", "rapid_override_percent", "spindle_override_percent"] as const;

export const MAX_OVERRIDE_PERCENT = 1000;

export const isSameSetup = (one: Readonly<Setup>, other: Readonly<Setup>): boolean =>
  (Object.keys(emptySetup()) as (keyof Setup)[]).every((key) => one[key] === other[key]);

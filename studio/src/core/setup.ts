// What a run is made of.

/** Names of documents (empty: none) and what the operator chooses. */
export interface Setup {
  program: string;
  /** Empty: the machine of the cell, or the one built in. */
  machine: string;
  /** "ab9", "rs274ngc"; empty: as the machine file says. */
  dialect: string;
  cell: string;
  machine_data: string;
  robots: string;
  /** A model that is built in, or a file, in place of the machine file's control; empty: as that says. */
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

/** Of a set-up, which are names of documents. */
export const fileKeys = ["program", "machine", "cell", "machine_data", "robots"] as const;
export const overrideKeys = ["feed_override_percent", "rapid_override_percent", "spindle_override_percent"] as const;

export const MOST_OVERRIDE_PERCENT = 1000;

export const isSameSetup = (one: Readonly<Setup>, other: Readonly<Setup>): boolean =>
  (Object.keys(emptySetup()) as (keyof Setup)[]).every((key) => one[key] === other[key]);

// Fixed and reference points as a path names them: by number or by name, among those of the machine data.

import type { MachinePointChange } from "./path_edit";
import type { MachinePoint } from "./path_file";

export const machinePointKinds = ["fixed", "reference"] as const;
export type MachinePointKind = (typeof machinePointKinds)[number];

/** Point of machine data; empty if it has no name. */
export interface KnownPoint {
  number: number;
  name: string;
}

/** Points of each kind in the machine data. */
export type KnownPoints = Record<MachinePointKind, readonly KnownPoint[]>;

export const noPoints: KnownPoints = { fixed: [], reference: [] };

/** Point that a path may use. */
export interface AvailablePoint {
  /** Name or number that the path uses for it. */
  value: string | number;
  /** Number of the entry of the machine data, or of the home position. */
  number: number;
  isHome: boolean;
}

/** Home positions; the first one is the home of the machine file, to which G28 moves. */
const HOME_NUMBERS = [1, 2, 3, 4];

export const machinePointKind = ({ fixed }: MachinePoint): MachinePointKind => (fixed === undefined ? "reference" : "fixed");
export const machinePointId = ({ fixed, reference }: MachinePoint): string | number => fixed ?? reference ?? "";

/** Converts a text: "2" is a number, any other text a name. */
export const parsePointId = (text: string): string | number => (/^\d+$/.test(text) ? Number(text) : text);

/**
 * Returns the possible points: homes by number, entries of section REFERENCE only by name, because both have
 * numbers.
 */
export function availablePoints(kind: MachinePointKind, known: KnownPoints): AvailablePoint[] {
  const entry = ({ number, name }: KnownPoint): AvailablePoint => ({ value: name || number, number, isHome: false });
  if (kind === "fixed") return known.fixed.map(entry);
  const homes = HOME_NUMBERS.map((number) => ({ value: number, number, isHome: true }));
  return [...homes, ...known.reference.filter(({ name }) => name !== "").map(entry)];
}

/** Returns the offered point that a path names; the case of names does not matter. */
export function findPoint(ident: string | number, listedOptions: readonly AvailablePoint[], kind: MachinePointKind): AvailablePoint | undefined {
  if (typeof ident === "string") return listedOptions.find(({ value }) => String(value).toUpperCase() === ident.toUpperCase());
  return listedOptions.find(({ number, isHome }) => number === ident && isHome === (kind === "reference"));
}

/** Returns the change that makes a point one of a kind: the first available one. */
export function firstPointOfKind(kind: MachinePointKind, known: KnownPoints): MachinePointChange {
  const value = availablePoints(kind, known)[0]?.value ?? 1;
  return kind === "fixed" ? { fixed: value, reference: undefined } : { fixed: undefined, reference: value };
}

/** Returns the point that is added first. */
export function firstMachinePoint(known: KnownPoints): MachinePoint {
  const [first] = availablePoints("fixed", known);
  return first ? { fixed: first.value } : { reference: HOME_NUMBERS[0] };
}

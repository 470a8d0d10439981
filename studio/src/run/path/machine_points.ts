// Fixed and reference points as a path names them: by number or by name, among those that machine data have.

import type { MachinePointChange } from "./path_edit";
import type { MachinePoint } from "./path_file";

export const machinePointKinds = ["fixed", "reference"] as const;
export type MachinePointKind = (typeof machinePointKinds)[number];

/** A point of machine data; without a name: empty. */
export interface KnownPoint {
  number: number;
  name: string;
}

/** What machine data have of each kind. */
export type KnownPoints = Record<MachinePointKind, readonly KnownPoint[]>;

export const noPoints: KnownPoints = { fixed: [], reference: [] };

/** A point that a path may go to. */
export interface OfferedPoint {
  /** By which the path names it. */
  value: string | number;
  /** Of the entry of the machine data, or of the home position. */
  number: number;
  isHome: boolean;
}

/** The first one is the home of the machine file, to which G28 goes. */
const HOMES = [1, 2, 3, 4];

export const kindOfMachinePoint = ({ fixed }: MachinePoint): MachinePointKind => (fixed === undefined ? "reference" : "fixed");
export const identOf = ({ fixed, reference }: MachinePoint): string | number => fixed ?? reference ?? "";

/** "2" is a number, all else a name. */
export const identFrom = (text: string): string | number => (/^\d+$/.test(text) ? Number(text) : text);

/** Homes go by their numbers, entries of section REFERENCE by their names alone: both have numbers. */
export function offeredPoints(kind: MachinePointKind, known: KnownPoints): OfferedPoint[] {
  const entry = ({ number, name }: KnownPoint): OfferedPoint => ({ value: name || number, number, isHome: false });
  if (kind === "fixed") return known.fixed.map(entry);
  const homes = HOMES.map((number) => ({ value: number, number, isHome: true }));
  return [...homes, ...known.reference.filter(({ name }) => name !== "").map(entry)];
}

/** The offered point that a path means; names go in any case. */
export function meantPoint(ident: string | number, offered: readonly OfferedPoint[], kind: MachinePointKind): OfferedPoint | undefined {
  if (typeof ident === "string") return offered.find(({ value }) => String(value).toUpperCase() === ident.toUpperCase());
  return offered.find(({ number, isHome }) => number === ident && isHome === (kind === "reference"));
}

/** What makes a point one of a kind: the first one that there is. */
export function pointOfKind(kind: MachinePointKind, known: KnownPoints): MachinePointChange {
  const value = offeredPoints(kind, known)[0]?.value ?? 1;
  return kind === "fixed" ? { fixed: value, reference: undefined } : { fixed: undefined, reference: value };
}

/** The point that is added at first. */
export function firstMachinePoint(known: KnownPoints): MachinePoint {
  const [first] = offeredPoints("fixed", known);
  return first ? { fixed: first.value } : { reference: HOMES[0] };
}

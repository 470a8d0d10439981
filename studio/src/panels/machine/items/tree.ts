// Relations between objects, frames and bodies of a file: their parents, and the changes that one causes in
// the others.

import { Matrix4 } from "three";
import { tableAt, tablesAt, textAt, valueAt, type TomlPath, type TomlChange, type TomlTable } from "../file/toml";
import { poseChanges, poseMatrix, toPose } from "./pose";

/** Tables of a cell or a machine that have a pose. */
export type ItemKind = "frame" | "object" | "shape";

/** Returns the key that names the parent. */
export const attachKey = (kind: ItemKind): string => (kind === "shape" ? "on" : "attached_to");

const DIGITS = 6;

interface AttachedItem {
  at: TomlPath;
  table: TomlTable;
}

/** Returns all tables of the file with this name in `attached_to`. */
function itemsAttachedTo(value: TomlTable, name: string): AttachedItem[] {
  return (["frame", "object"] as const).flatMap((kind) =>
    tablesAt(value, [kind]).flatMap((table, i): AttachedItem[] => (table.attached_to === name ? [{ at: [kind, i], table }] : [])),
  );
}

/** Pairs that may touch. */
export function ignoredPairs(value: TomlTable): [string, string][] {
  const list = valueAt(value, ["ignore"]);
  if (!Array.isArray(list)) return [];
  return list.map((pair): [string, string] => (Array.isArray(pair) ? [String(pair[0]), String(pair[1])] : ["", ""]));
}

/** Returns the changes for a new name, also in references. */
export function renameChanges(value: TomlTable, at: TomlPath, from: string, to: string): TomlChange[] {
  const attached = itemsAttachedTo(value, from).map(({ at: place }): TomlChange => ({ op: "set", at: [...place, "attached_to"], value: to }));
  const ignored = ignoredPairs(value).flatMap((pair, i) =>
    pair.flatMap((name, part): TomlChange[] => (name === from ? [{ op: "set", at: ["ignore", i, part], value: to }] : [])),
  );
  return [{ op: "set", at: [...at, "name"], value: to }, ...attached, ...ignored];
}

/** Removes an item: attached items keep their pose, and pairs with it are removed. */
export function removeChanges(value: TomlTable, kind: ItemKind, index: number): TomlChange[] {
  const table = tablesAt(value, [kind])[index];
  const name = textAt(table, ["name"]);
  const parent = textAt(table, ["attached_to"]);
  const own = poseMatrix(tableAt(table, ["frame"]));
  const left = itemsAttachedTo(value, name).flatMap(({ at, table: other }): TomlChange[] => {
    const pose = tableAt(other, ["frame"]);
    const place = toPose(new Matrix4().multiplyMatrices(own, poseMatrix(pose)), DIGITS);
    const again: TomlChange = parent ? { op: "set", at: [...at, "attached_to"], value: parent } : { op: "remove", at: [...at, "attached_to"] };
    return [again, ...poseChanges([...at, "frame"], pose, place)];
  });
  const pairs = ignoredPairs(value).flatMap((pair, i): number[] => (pair.includes(name) ? [i] : [])).reverse();
  return [...left, ...pairs.map((i): TomlChange => ({ op: "remove", at: ["ignore", i] })), { op: "remove", at: [kind, index] }];
}

/** Returns a free name: "clamp 2", if "clamp" is taken. */
export function freeItemName(name: string, isTaken: (name: string) => boolean): string {
  const stem = name.replace(/ \d+$/, "");
  let free = name;
  for (let i = 2; isTaken(free); ++i) free = `${stem} ${i}`;
  return free;
}

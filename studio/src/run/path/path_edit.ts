// Changes of a path file's text. Each returns the new text; unchanged parts keep their layout.

import { FILE_FORMAT } from "../../core/file_format";
import {
  changeValue,
  insertItems,
  insertTexts,
  jsonLine,
  readJson,
  removeItems,
  reorderItems,
  replaceValue,
  setMember,
  itemTexts,
  type JsonValue,
} from "../../core/json_text";
import { arcTo, isPlainArc, arcPoint } from "./path_arc";
import {
  findPathIndex,
  isMachinePoint,
  isSameTarget,
  isSubPath,
  targetJsonPath,
  pathKeys,
  pointAt,
  rootIndex,
  type MachinePoint,
  type PathFile,
  type TargetId,
  type Point,
  type SetUp,
  type SubPath,
  type Target,
  type WorkFrame,
} from "./path_file";
import { machinePointKeys, pointKeys, subPathKeys } from "./target_checks";
import { roundedVector, type Vector } from "./vector";
import type { PathTraversal } from "./path_traversal";

/** Values to set; undefined ones are removed. */
type PartialChange<Object> = { [Key in keyof Object]?: Object[Key] | undefined };
export type PointChange = PartialChange<Point>;
export type SubPathChange = PartialChange<SubPath>;
export type MachinePointChange = PartialChange<MachinePoint>;
export type SetUpChange = PartialChange<SetUp>;
export type FrameChange = PartialChange<WorkFrame>;

const targetsPath = (path: number) => ["paths", path, "targets"];

/** Returns the text of an object with changed members; new ones follow `order`. */
function setMembers(object: string, change: object, order: readonly string[]): string {
  // Removals come first: at most one of two kinds of orientation may exist.
  const all = Object.entries(change).sort((a, b) => Number(a[1] !== undefined) - Number(b[1] !== undefined));
  return all.reduce((text, [key, value]) => setMember(text, [], key, value as JsonValue, order), object);
}

function targetKeys(target: Target): readonly string[] {
  if (isSubPath(target)) return subPathKeys;
  return isMachinePoint(target) ? machinePointKeys : pointKeys;
}

/** Sets or removes members of a target, one after another. */
export const setTarget = (text: string, place: TargetId, change: PointChange | SubPathChange | MachinePointChange): string =>
  changeValue(text, targetJsonPath(place), (target) => setMembers(target, change, targetKeys(readJson(target) as unknown as Target)));

/** Sets or removes the work frame and the tool of a path. */
export const setPath = (text: string, path: number, change: SetUpChange): string =>
  changeValue(text, ["paths", path], (own) => setMembers(own, change, pathKeys));

/** Inserts targets before one of a path, by its number; if that does not exist, at the end. */
export const insertTargets = (text: string, path: number, before: number, targets: Target[]): string =>
  insertItems(text, targetsPath(path), before, targets as unknown as JsonValue[]);

/** Inserts targets after a place; for the path itself, at its end. */
export const addTargets = (text: string, file: PathFile, { path, target }: TargetId, targets: Target[]): string =>
  insertTargets(text, path, target < 0 ? file.paths[path].targets.length : target + 1, targets);

/** Removes targets; a path keeps at least one. */
export function removeTargets(text: string, file: PathFile, { path, target }: TargetId, count: number): string {
  return count < file.paths[path].targets.length ? removeItems(text, targetsPath(path), target, count) : text;
}

/** Inserts a copy of targets after them. */
export const duplicateTargets = (text: string, { path, target }: TargetId, count: number): string =>
  insertTexts(text, targetsPath(path), target + count, itemTexts(text, targetsPath(path), target, count));

/** Moves targets to the position of another one of their path. */
export function moveTargets(text: string, file: PathFile, { path, target }: TargetId, count: number, to: number): string {
  const all = file.paths[path].targets.map((_, i) => i);
  const moved = all.splice(target, count);
  all.splice(Math.min(Math.max(to, 0), all.length), 0, ...moved);
  return reorderItems(text, targetsPath(path), all);
}

/** Returns "part 2" if "part" is taken. */
export function freeName(file: PathFile, requested: string): string {
  let name = requested;
  for (let i = 2; findPathIndex(file, name) >= 0; ++i) name = `${requested} ${i}`;
  return name;
}

/** Returns a path as in files: a line for each target. */
const pathText = (name: string, targets: string[]): string =>
  `{"name": ${JSON.stringify(name)}, "targets": [\n${targets.map((target) => `  ${target}`).join(",\n")}\n]}`;

/** Makes some targets a path of its own at the end of the file, and uses it in their place. */
export function makeSubPath(text: string, file: PathFile, place: TargetId, count: number, name: string): string {
  const { path, target } = place;
  const made = pathText(name, itemTexts(text, targetsPath(path), target, count));
  const replaced = replaceValue(text, targetJsonPath(place), { path: name });
  const without = count > 1 ? removeItems(replaced, targetsPath(path), target + 1, count - 1) : replaced;
  return insertTexts(without, ["paths"], file.paths.length, [made]);
}

/** Removes a path that nothing uses. */
export function removePath(text: string, file: PathFile, path: number): string {
  return file.paths.length > 1 && path !== rootIndex(file) && referencesTo(file, file.paths[path].name).length === 0
    ? removeItems(text, ["paths"], path, 1)
    : text;
}

/** Returns the places that use a path. */
export const referencesTo = (file: PathFile, name: string): TargetId[] =>
  file.paths.flatMap(({ targets }, path) =>
    targets.flatMap((each, target) => (isSubPath(each) && each.path === name ? [{ path, target }] : [])),
  );

/** Renames a path and all references to it. */
export function renamePath(text: string, file: PathFile, path: number, name: string): string {
  const before = file.paths[path].name;
  let changed = replaceValue(text, ["paths", path, "name"], name);
  for (const place of referencesTo(file, before)) changed = setTarget(changed, place, { path: name });
  return file.root === before ? setRoot(changed, name) : changed;
}

export const setRoot = (text: string, name: string): string =>
  setMember(text, [], "root", name, ["$schema", "format", "name", "root", "work_offsets", "paths"]);

/** Returns the text of a new file with one path of one point. */
export const newPathFile = (name: string, point: Point): string =>
  `{\n"format": ${FILE_FORMAT},\n"name": ${JSON.stringify(name)},\n"root": ${JSON.stringify(name)},\n"paths": [\n` +
  `${pathText(name, [jsonLine(point as unknown as JsonValue)])}\n]\n}\n`;

/**
 * Moves a point. Arcs about a centre that begin or end there, and do not fit any more, become arcs through
 * the middle of the old ones.
 */
export function movePoint(text: string, file: PathFile, walk: PathTraversal, place: TargetId, position_mm: Vector): string {
  const to = roundedVector(position_mm);
  let changed = setTarget(text, place, { position_mm: to });
  for (const { place: arcPlace, after, from_mm, to_mm, arc } of walk.motions) {
    const [ends, begins] = [isSameTarget(arcPlace, place), isSameTarget(after, place)];
    const point = pointAt(file, arcPlace);
    if (!arc || !from_mm || !point?.center_mm || !(ends || begins)) continue;
    const fits = typeof arcTo(begins ? to : from_mm, ends ? { ...point, position_mm: to } : point) !== "string";
    if (fits || !isPlainArc(arc, begins ? to : from_mm, ends ? to : to_mm)) continue;
    const via_mm = roundedVector(arcPoint(arc, 0.5));
    changed = setTarget(changed, arcPlace, { via_mm, center_mm: undefined, normal: undefined, turn_deg: undefined });
  }
  return changed;
}

// Actions on the chosen points of a path: each is a step of the history.

import { editPath } from "../../core/path_editing";
import type { DisplayedPath } from "../../core/displayed_path";
import type { Session } from "../../core/session";
import type { Store } from "../../core/store";
import { addLeads, type LeadChoice } from "../../run/path/leads";
import {
  addTargets,
  duplicateTargets,
  freeName,
  makeSubPath,
  moveTargets,
  removePath,
  removeTargets,
  referencesTo,
} from "../../run/path/path_edit";
import { isMachinePoint, isPoint, isRecorded, pointAt, rootIndex, targetAt, type MachinePoint, type TargetId, type Point, type Target } from "../../run/path/path_file";
import { add, between, roundedVector, scaled, subtract, unit, type Vector } from "../../run/path/vector";
import { texts } from "../../texts";
import type { TargetSelection, Range } from "./target_selection";
import type { TreeActions } from "./tree";

const words = texts.paths;
/** Distance of a new point from the last one of a path. */
const DEFAULT_STEP_MM = 10;

export class PathActions implements TreeActions {
  constructor(
    private readonly store: Store,
    private readonly session: Session,
    private readonly choice: TargetSelection,
    /** Shows why something is not done; empty: it is done. */
    private readonly say: (sentence: string) => void,
  ) {}

  private get displayed(): DisplayedPath | null {
    const displayed = this.store.get("path");
    return displayed && !displayed.error ? displayed : null;
  }

  private edit(label: string, text: string, range: Range | null = null): void {
    this.say("");
    editPath(this.store, this.session, label, text);
    if (range) this.choice.selectRange(range);
  }

  /** Returns the position after the selection; without one, the end of the path to begin with. */
  private get behind(): { displayed: DisplayedPath; place: TargetId } | null {
    const { displayed } = this;
    if (!displayed) return null;
    const { range } = this.choice;
    if (!range) return { displayed, place: endOfPath(displayed, Math.max(rootIndex(displayed.file), 0)) };
    const { path, target } = range.place;
    return { displayed, place: target < 0 ? endOfPath(displayed, path) : { path, target: target + range.count - 1 } };
  }

  private insert(label: string, target: Target): void {
    const at = this.behind;
    if (!at) return;
    const { path, target: before } = at.place;
    this.edit(label, addTargets(at.displayed.text, at.displayed.file, at.place, [target]), { place: { path, target: before + 1 }, count: 1 });
  }

  /** Inserts a point and selects it. */
  addPoint(point: Point, label: string = words.labels.add): void {
    this.insert(label, point);
  }

  /** Adds a point halfway to the next one, or beyond the last one. */
  add(): void {
    const at = this.behind;
    if (!at) return;
    const before = targetAt(at.displayed.file, at.place);
    // The position of a machine point in the work is unknown: only a rapid leads from there.
    const motion = before && isMachinePoint(before) ? "rapid" : "linear";
    this.addPoint({ motion, position_mm: insertionPosition(at.displayed, at.place) });
  }

  addMachinePoint(point: MachinePoint): void {
    const { displayed } = this;
    if (!displayed) return;
    if (isRecorded(displayed.file)) return this.say(words.machinePoint.notRecorded);
    this.insert(words.labels.addMachinePoint, point);
  }

  addSubPath(name: string): void {
    this.insert(words.labels.addSubPath, { path: name });
  }

  duplicate(): void {
    const [{ displayed }, { range }] = [this, this.choice];
    if (!displayed || !range || range.place.target < 0) return;
    const { place, count } = range;
    const copies = { place: { path: place.path, target: place.target + count }, count };
    this.edit(words.labels.duplicate, duplicateTargets(displayed.text, place, count), copies);
  }

  remove(): void {
    const [{ displayed }, { range }] = [this, this.choice];
    if (!displayed || !range) return;
    const { path, target } = range.place;
    const { name, targets } = displayed.file.paths[path];
    if (target < 0) return this.removePath(displayed, path);
    if (range.count === targets.length) return this.say(words.tree.lastTarget(name));
    const next = Math.min(target, targets.length - range.count - 1);
    this.edit(words.labels.remove, removeTargets(displayed.text, displayed.file, range.place, range.count), { place: { path, target: next }, count: 1 });
  }

  private removePath(displayed: DisplayedPath, path: number): void {
    const { name } = displayed.file.paths[path];
    const usingPaths = referencesTo(displayed.file, name).map((place) => displayed.file.paths[place.path].name);
    if (usingPaths.length > 0) return this.say(words.tree.isUsed(name, [...new Set(usingPaths)].join(", ")));
    if (path === rootIndex(displayed.file)) return this.say(words.tree.isRoot(name));
    this.store.set("pathPoint", null);
    this.edit(words.labels.removePath, removePath(displayed.text, displayed.file, path));
  }

  move(by: number): void {
    const { range } = this.choice;
    if (range) this.moveToIndex(range, range.place.target + by);
  }

  moveTo(place: TargetId): void {
    const { range } = this.choice;
    if (!range || this.choice.has(place)) return;
    // After the target if that is further down, before it if it is further up.
    this.moveToIndex(range, place.target > range.place.target ? place.target - range.count + 1 : place.target);
  }

  private moveToIndex({ place, count }: Range, to: number): void {
    const { displayed } = this;
    const last = (displayed?.file.paths[place.path].targets.length ?? 0) - count;
    if (!displayed || place.target < 0 || to < 0 || to > last) return;
    const moved = { place: { path: place.path, target: to }, count };
    this.edit(words.labels.order, moveTargets(displayed.text, displayed.file, place, count, to), moved);
  }

  makeSubPath(): void {
    const [{ displayed }, { range }] = [this, this.choice];
    if (!displayed || !range || range.place.target < 0) return;
    const { place, count } = range;
    const name = freeName(displayed.file, words.tree.newSubPath);
    this.edit(words.labels.makeSubPath, makeSubPath(displayed.text, displayed.file, place, count, name), { place, count: 1 });
  }

  addLeads(choice: LeadChoice): void {
    const { displayed } = this;
    const range = this.choice.range ?? { place: { path: Math.max(rootIndex(displayed?.file ?? { paths: [] }), 0), target: -1 }, count: 1 };
    if (!displayed) return;
    const all = { place: { path: range.place.path, target: 0 }, count: displayed.file.paths[range.place.path].targets.length };
    // A single point selects its path, because a contour has several points.
    const { place, count } = range.count > 1 ? range : all;
    const made = addLeads(displayed.text, displayed.file, displayed.walk, place, count, choice);
    if (typeof made === "string") this.edit(words.labels.leads, made);
    else this.say(made.error);
  }
}

const endOfPath = ({ file }: DisplayedPath, path: number): TargetId => ({ path, target: file.paths[path].targets.length - 1 });

/** Returns a position for a point after another one. */
function insertionPosition({ file, walk }: DisplayedPath, place: TargetId): Vector {
  const { path, target } = place;
  const here = pointAt(file, place)?.position_mm ?? walk.motions.find((motion) => motion.place.path === path)?.to_mm ?? [0, 0, 0];
  const next = file.paths[path].targets[target + 1];
  if (next && isPoint(next)) return roundedVector(between(here, next.position_mm, 0.5));
  const before = pointAt(file, { path, target: target - 1 })?.position_mm;
  const along = (before && unit(subtract(here, before))) ?? [1, 0, 0];
  return roundedVector(add(here, scaled(along, DEFAULT_STEP_MM)));
}

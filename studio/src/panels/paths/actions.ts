// Actions on the chosen points of a path: each is a step of the history.

import { editPath } from "../../core/path_desk";
import type { PathShown } from "../../core/path_shown";
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
  usersOf,
} from "../../run/path/path_edit";
import { isMachinePoint, isPoint, isRecorded, pointAt, rootOf, targetAt, type MachinePoint, type Place, type Point, type Target } from "../../run/path/path_file";
import { add, between, roundedVector, scaled, subtract, unit, type Vector } from "../../run/path/vector";
import { texts } from "../../texts";
import type { PointChoice, Range } from "./choice_of_points";
import type { TreeActions } from "./tree";

const words = texts.paths;
/** Distance of a new point from the last one of a path. */
const STEP_MM = 10;

export class PathActions implements TreeActions {
  constructor(
    private readonly store: Store,
    private readonly session: Session,
    private readonly choice: PointChoice,
    /** Shows why something is not done; empty: it is done. */
    private readonly say: (sentence: string) => void,
  ) {}

  private get shown(): PathShown | null {
    const shown = this.store.get("path");
    return shown && !shown.fault ? shown : null;
  }

  private edit(label: string, text: string, range: Range | null = null): void {
    this.say("");
    editPath(this.store, this.session, label, text);
    if (range) this.choice.chooseRange(range);
  }

  /** Returns the position after the selection; without one, the end of the path to begin with. */
  private get behind(): { shown: PathShown; place: Place } | null {
    const { shown } = this;
    if (!shown) return null;
    const { range } = this.choice;
    if (!range) return { shown, place: lastOf(shown, Math.max(rootOf(shown.file), 0)) };
    const { path, target } = range.place;
    return { shown, place: target < 0 ? lastOf(shown, path) : { path, target: target + range.count - 1 } };
  }

  private insert(label: string, target: Target): void {
    const at = this.behind;
    if (!at) return;
    const { path, target: before } = at.place;
    this.edit(label, addTargets(at.shown.text, at.shown.file, at.place, [target]), { place: { path, target: before + 1 }, count: 1 });
  }

  /** Inserts a point and selects it. */
  addPoint(point: Point, label: string = words.labels.add): void {
    this.insert(label, point);
  }

  /** Adds a point halfway to the next one, or beyond the last one. */
  add(): void {
    const at = this.behind;
    if (!at) return;
    const before = targetAt(at.shown.file, at.place);
    // The position of a machine point in the work is unknown: only a rapid leads from there.
    const motion = before && isMachinePoint(before) ? "rapid" : "linear";
    this.addPoint({ motion, position_mm: placeBehind(at.shown, at.place) });
  }

  addMachinePoint(point: MachinePoint): void {
    const { shown } = this;
    if (!shown) return;
    if (isRecorded(shown.file)) return this.say(words.machinePoint.notRecorded);
    this.insert(words.labels.addMachinePoint, point);
  }

  addSubPath(name: string): void {
    this.insert(words.labels.addSubPath, { path: name });
  }

  duplicate(): void {
    const [{ shown }, { range }] = [this, this.choice];
    if (!shown || !range || range.place.target < 0) return;
    const { place, count } = range;
    const copies = { place: { path: place.path, target: place.target + count }, count };
    this.edit(words.labels.duplicate, duplicateTargets(shown.text, place, count), copies);
  }

  remove(): void {
    const [{ shown }, { range }] = [this, this.choice];
    if (!shown || !range) return;
    const { path, target } = range.place;
    const { name, targets } = shown.file.paths[path];
    if (target < 0) return this.removePath(shown, path);
    if (range.count === targets.length) return this.say(words.tree.lastTarget(name));
    const next = Math.min(target, targets.length - range.count - 1);
    this.edit(words.labels.remove, removeTargets(shown.text, shown.file, range.place, range.count), { place: { path, target: next }, count: 1 });
  }

  private removePath(shown: PathShown, path: number): void {
    const { name } = shown.file.paths[path];
    const users = usersOf(shown.file, name).map((place) => shown.file.paths[place.path].name);
    if (users.length > 0) return this.say(words.tree.isUsed(name, [...new Set(users)].join(", ")));
    if (path === rootOf(shown.file)) return this.say(words.tree.isRoot(name));
    this.store.set("pathPoint", null);
    this.edit(words.labels.removePath, removePath(shown.text, shown.file, path));
  }

  move(by: number): void {
    const { range } = this.choice;
    if (range) this.moveToIndex(range, range.place.target + by);
  }

  moveTo(place: Place): void {
    const { range } = this.choice;
    if (!range || this.choice.has(place)) return;
    // After the target if that is further down, before it if it is further up.
    this.moveToIndex(range, place.target > range.place.target ? place.target - range.count + 1 : place.target);
  }

  private moveToIndex({ place, count }: Range, to: number): void {
    const { shown } = this;
    const last = (shown?.file.paths[place.path].targets.length ?? 0) - count;
    if (!shown || place.target < 0 || to < 0 || to > last) return;
    const moved = { place: { path: place.path, target: to }, count };
    this.edit(words.labels.order, moveTargets(shown.text, shown.file, place, count, to), moved);
  }

  makeSubPath(): void {
    const [{ shown }, { range }] = [this, this.choice];
    if (!shown || !range || range.place.target < 0) return;
    const { place, count } = range;
    const name = freeName(shown.file, words.tree.newSubPath);
    this.edit(words.labels.makeSubPath, makeSubPath(shown.text, shown.file, place, count, name), { place, count: 1 });
  }

  addLeads(choice: LeadChoice): void {
    const { shown } = this;
    const range = this.choice.range ?? { place: { path: Math.max(rootOf(shown?.file ?? { paths: [] }), 0), target: -1 }, count: 1 };
    if (!shown) return;
    const all = { place: { path: range.place.path, target: 0 }, count: shown.file.paths[range.place.path].targets.length };
    // A single point selects its path, because a contour has several points.
    const { place, count } = range.count > 1 ? range : all;
    const made = addLeads(shown.text, shown.file, shown.walk, place, count, choice);
    if (typeof made === "string") this.edit(words.labels.leads, made);
    else this.say(made.fault);
  }
}

const lastOf = ({ file }: PathShown, path: number): Place => ({ path, target: file.paths[path].targets.length - 1 });

/** Returns a position for a point after another one. */
function placeBehind({ file, walk }: PathShown, place: Place): Vector {
  const { path, target } = place;
  const here = pointAt(file, place)?.position_mm ?? walk.motions.find((motion) => motion.place.path === path)?.to_mm ?? [0, 0, 0];
  const next = file.paths[path].targets[target + 1];
  if (next && isPoint(next)) return roundedVector(between(here, next.position_mm, 0.5));
  const before = pointAt(file, { path, target: target - 1 })?.position_mm;
  const along = (before && unit(subtract(here, before))) ?? [1, 0, 0];
  return roundedVector(add(here, scaled(along, STEP_MM)));
}

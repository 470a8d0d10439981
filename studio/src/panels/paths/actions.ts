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
    private readonly showMessage: (message: string) => void,
  ) {}

  private get displayed(): DisplayedPath | null {
    const displayed = this.store.get("path");
    return displayed && !displayed.error ? displayed : null;
  }

  private edit(label: string, text: string, range: Range | null = null): void {
    this.showMessage("");
    editPath(this.store, this.session, label, text);
    if (range) this.choice.selectRange(range);
  }

  /** Returns the position after the selection; without one, the end of the path to begin with. */
  private get insertionTarget(): { displayed: DisplayedPath; targetId: TargetId } | null {
    const { displayed } = this;
    if (!displayed) return null;
    const { range } = this.choice;
    if (!range) return { displayed, targetId: endOfPath(displayed, Math.max(rootIndex(displayed.file), 0)) };
    const { path, target } = range.targetId;
    return { displayed, targetId: target < 0 ? endOfPath(displayed, path) : { path, target: target + range.count - 1 } };
  }

  private insert(label: string, target: Target): void {
    const at = this.insertionTarget;
    if (!at) return;
    const { path, target: before } = at.targetId;
    this.edit(label, addTargets(at.displayed.text, at.displayed.file, at.targetId, [target]), { targetId: { path, target: before + 1 }, count: 1 });
  }

  /** Inserts a point and selects it. */
  addPoint(point: Point, label: string = words.labels.add): void {
    this.insert(label, point);
  }

  /** Adds a point halfway to the next one, or beyond the last one. */
  add(): void {
    const at = this.insertionTarget;
    if (!at) return;
    const before = targetAt(at.displayed.file, at.targetId);
    // The position of a machine point in the work is unknown: only a rapid leads from there.
    const motion = before && isMachinePoint(before) ? "rapid" : "linear";
    this.addPoint({ motion, position_mm: insertionPosition(at.displayed, at.targetId) });
  }

  addMachinePoint(point: MachinePoint): void {
    const { displayed } = this;
    if (!displayed) return;
    if (isRecorded(displayed.file)) return this.showMessage(words.machinePoint.notRecorded);
    this.insert(words.labels.addMachinePoint, point);
  }

  addSubPath(name: string): void {
    this.insert(words.labels.addSubPath, { path: name });
  }

  duplicate(): void {
    const [{ displayed }, { range }] = [this, this.choice];
    if (!displayed || !range || range.targetId.target < 0) return;
    const { targetId, count } = range;
    const copies = { targetId: { path: targetId.path, target: targetId.target + count }, count };
    this.edit(words.labels.duplicate, duplicateTargets(displayed.text, targetId, count), copies);
  }

  remove(): void {
    const [{ displayed }, { range }] = [this, this.choice];
    if (!displayed || !range) return;
    const { path, target } = range.targetId;
    const { name, targets } = displayed.file.paths[path];
    if (target < 0) return this.removePath(displayed, path);
    if (range.count === targets.length) return this.showMessage(words.tree.lastTarget(name));
    const next = Math.min(target, targets.length - range.count - 1);
    this.edit(words.labels.remove, removeTargets(displayed.text, displayed.file, range.targetId, range.count), { targetId: { path, target: next }, count: 1 });
  }

  private removePath(displayed: DisplayedPath, path: number): void {
    const { name } = displayed.file.paths[path];
    const usingPaths = referencesTo(displayed.file, name).map((targetId) => displayed.file.paths[targetId.path].name);
    if (usingPaths.length > 0) return this.showMessage(words.tree.isUsed(name, [...new Set(usingPaths)].join(", ")));
    if (path === rootIndex(displayed.file)) return this.showMessage(words.tree.isRoot(name));
    this.store.set("pathPoint", null);
    this.edit(words.labels.removePath, removePath(displayed.text, displayed.file, path));
  }

  move(by: number): void {
    const { range } = this.choice;
    if (range) this.moveToIndex(range, range.targetId.target + by);
  }

  moveTo(targetId: TargetId): void {
    const { range } = this.choice;
    if (!range || this.choice.has(targetId)) return;
    // After the target if that is further down, before it if it is further up.
    this.moveToIndex(range, targetId.target > range.targetId.target ? targetId.target - range.count + 1 : targetId.target);
  }

  private moveToIndex({ targetId, count }: Range, to: number): void {
    const { displayed } = this;
    const last = (displayed?.file.paths[targetId.path].targets.length ?? 0) - count;
    if (!displayed || targetId.target < 0 || to < 0 || to > last) return;
    const moved = { targetId: { path: targetId.path, target: to }, count };
    this.edit(words.labels.order, moveTargets(displayed.text, displayed.file, targetId, count, to), moved);
  }

  makeSubPath(): void {
    const [{ displayed }, { range }] = [this, this.choice];
    if (!displayed || !range || range.targetId.target < 0) return;
    const { targetId, count } = range;
    const name = freeName(displayed.file, words.tree.newSubPath);
    this.edit(words.labels.makeSubPath, makeSubPath(displayed.text, displayed.file, targetId, count, name), { targetId, count: 1 });
  }

  addLeads(choice: LeadChoice): void {
    const { displayed } = this;
    const range = this.choice.range ?? { targetId: { path: Math.max(rootIndex(displayed?.file ?? { paths: [] }), 0), target: -1 }, count: 1 };
    if (!displayed) return;
    const all = { targetId: { path: range.targetId.path, target: 0 }, count: displayed.file.paths[range.targetId.path].targets.length };
    // A single point selects its path, because a contour has several points.
    const { targetId, count } = range.count > 1 ? range : all;
    const result = addLeads(displayed.text, displayed.file, displayed.walk, targetId, count, choice);
    if (typeof result === "string") this.edit(words.labels.leads, result);
    else this.showMessage(result.error);
  }
}

const endOfPath = ({ file }: DisplayedPath, path: number): TargetId => ({ path, target: file.paths[path].targets.length - 1 });

/** Returns a position for a point after another one. */
function insertionPosition({ file, walk }: DisplayedPath, targetId: TargetId): Vector {
  const { path, target } = targetId;
  const here = pointAt(file, targetId)?.position_mm ?? walk.motions.find((motion) => motion.targetId.path === path)?.to_mm ?? [0, 0, 0];
  const next = file.paths[path].targets[target + 1];
  if (next && isPoint(next)) return roundedVector(between(here, next.position_mm, 0.5));
  const before = pointAt(file, { path, target: target - 1 })?.position_mm;
  const along = (before && unit(subtract(here, before))) ?? [1, 0, 0];
  return roundedVector(add(here, scaled(along, DEFAULT_STEP_MM)));
}

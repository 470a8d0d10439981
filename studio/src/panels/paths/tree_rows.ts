// Rows of the tree of a path file: the root, its sub-paths, and at the end the paths that nothing leads to.

import type { PathShown } from "../../core/path_shown";
import {
  indexOfPath,
  isPoint,
  isSamePlace,
  isSubPath,
  keyOfPlace,
  motionOf,
  rootOf,
  type MotionType,
  type Place,
  type Target,
} from "../../run/path/path_file";

export interface TreeRow {
  /** Position in the tree: numbers of paths and targets. */
  key: string;
  level: number;
  place: Place;
  /** Number of the path below it; -1: a point, or a path that does not exist. */
  below: number;
  open: boolean;
  /** Of a point. */
  motion: MotionType | null;
  target: Target | null;
  /** Number of hidden targets before or after the shown ones that it represents; 0: it is a target itself. */
  more: number;
  fault: string;
}

/** Number of targets of a path that are shown at first, and that are added at a time. */
const SHOWN = 200;

/** Range of targets; the end is excluded. */
interface Window {
  first: number;
  end: number;
}

export class TreeState {
  private readonly open = new Set<string>();
  private readonly windows = new Map<string, Window>();

  isOpen(key: string): boolean {
    return this.open.has(key);
  }

  set(key: string, open: boolean): void {
    if (open) this.open.add(key);
    else this.open.delete(key);
  }

  /** Returns the shown targets of a path, by the key of its row. */
  window(key: string): Window {
    return this.windows.get(key) ?? { first: 0, end: SHOWN };
  }

  /** Shows more targets, next to the given one, which is the first hidden one. */
  widen(key: string, target: number): void {
    const { first, end } = this.window(key);
    this.windows.set(key, target < first ? { first: Math.max(first - SHOWN, 0), end } : { first, end: end + SHOWN });
  }

  /** Shows a target, with its neighbours if it was not shown. */
  reveal(key: string, target: number): void {
    const { first, end } = this.window(key);
    if (target >= first && target < end) return;
    const begin = Math.max(target - SHOWN / 2, 0);
    this.windows.set(key, { first: begin, end: begin + SHOWN });
  }
}

const plainRow = { below: -1, open: false, motion: null, target: null, more: 0, fault: "" };

function* rowsBelow(shown: PathShown, state: TreeState, parent: TreeRow, faults: Map<string, string>): Generator<TreeRow> {
  const { targets } = shown.file.paths[parent.below];
  const { first, end } = state.window(parent.key);
  const more = (target: number, count: number) => {
    const place = { path: parent.below, target };
    return { ...plainRow, key: `${parent.key}/more`, level: parent.level + 1, place, more: count };
  };
  // After targets were removed, a window may begin past the last one.
  const begin = Math.min(first, Math.max(targets.length - SHOWN, 0));
  if (begin > 0) yield more(begin - 1, begin);
  for (let target = begin; target < Math.min(targets.length, end); ++target) {
    const each = targets[target];
    const place = { path: parent.below, target };
    const key = `${parent.key}/${target}`;
    const row = { ...plainRow, key, level: parent.level + 1, place, target: each, fault: faults.get(keyOfPlace(place)) ?? "" };
    if (!isSubPath(each)) {
      yield { ...row, motion: isPoint(each) ? motionOf(each) : "rapid" };
      continue;
    }
    // A path that leads back to itself is not opened.
    const below = row.fault ? -1 : indexOfPath(shown.file, each.path);
    const sub = { ...row, below, open: below >= 0 && state.isOpen(key) };
    yield sub;
    if (sub.open) yield* rowsBelow(shown, state, sub, faults);
  }
  if (targets.length > end) yield more(end, targets.length - end);
}

/** Returns all visible rows. */
export function* rowsOf(shown: PathShown, state: TreeState): Generator<TreeRow> {
  const { file, walk } = shown;
  const faults = new Map(walk.faults.flatMap(({ place, text }) => (place ? [[keyOfPlace(place), text] as const] : [])));
  const root = Math.max(rootOf(file), 0);
  const tops = [root, ...file.paths.keys()].filter((path, i) => i === 0 || !walk.used.has(path));
  for (const path of tops) {
    if (!file.paths[path] || (path === root && tops.indexOf(path) > 0)) continue;
    const place = { path, target: -1 };
    const key = String(path);
    const row = { ...plainRow, key, level: 1, place, below: path, open: state.isOpen(key), fault: faults.get(keyOfPlace(place)) ?? "" };
    yield row;
    if (row.open) yield* rowsBelow(shown, state, row, faults);
  }
}

/** Opens the rows that hide a place, along the first route to it. */
export function reveal({ file, walk }: PathShown, state: TreeState, place: Place): void {
  const root = Math.max(rootOf(file), 0);
  const way = wayTo(file, root, place.path, []) ?? (walk.used.has(place.path) ? null : []);
  if (!way) return;
  let key = String(way.length > 0 || place.path === root ? root : place.path);
  let path = root;
  for (const target of way) {
    open(state, key, target);
    key += `/${target}`;
    path = indexOfPath(file, (file.paths[path].targets[target] as { path: string }).path);
  }
  if (place.target >= 0) open(state, key, place.target);
}

function open(state: TreeState, key: string, target: number): void {
  state.set(key, true);
  state.reveal(key, target);
}

/** Returns the numbers of the targets that lead from one path to another; null: none. */
function wayTo(file: PathShown["file"], from: number, to: number, way: number[], seen = new Set<number>()): number[] | null {
  if (from === to) return way;
  if (seen.has(from)) return null;
  seen.add(from);
  const targets = file.paths[from]?.targets ?? [];
  for (let i = 0; i < targets.length; ++i) {
    const each = targets[i];
    if (!isSubPath(each)) continue;
    const below = indexOfPath(file, each.path);
    const found = below < 0 ? null : wayTo(file, below, to, [...way, i], seen);
    if (found) return found;
  }
  return null;
}

/** True if a row represents a place. */
export const isRowOf = (row: TreeRow, place: Place | null): boolean => row.more === 0 && isSamePlace(row.place, place);

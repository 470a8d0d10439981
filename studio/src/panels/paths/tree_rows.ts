// Rows of the tree of a path file: the root, its sub-paths, and at the end the paths that nothing leads to.

import type { DisplayedPath } from "../../core/displayed_path";
import {
  findPathIndex,
  isPoint,
  isSameTarget,
  isSubPath,
  targetKey,
  pointMotion,
  rootIndex,
  type MotionType,
  type TargetId,
  type Target,
} from "../../run/path/path_file";

export interface TreeRow {
  /** Position in the tree: numbers of paths and targets. */
  key: string;
  level: number;
  place: TargetId;
  /** Number of the path below it; -1: a point, or a path that does not exist. */
  below: number;
  open: boolean;
  /** Of a point. */
  motion: MotionType | null;
  target: Target | null;
  /** Number of hidden targets before or after the shown ones that it represents; 0: it is a target itself. */
  more: number;
  error: string;
}

/** Number of targets of a path that are shown at first, and that are added at a time. */
const ROWS_PER_STEP = 200;

/** Range of targets; the end is excluded. */
interface RowWindow {
  first: number;
  end: number;
}

export class TreeState {
  private readonly open = new Set<string>();
  private readonly windows = new Map<string, RowWindow>();

  isOpen(key: string): boolean {
    return this.open.has(key);
  }

  set(key: string, open: boolean): void {
    if (open) this.open.add(key);
    else this.open.delete(key);
  }

  /** Returns the shown targets of a path, by the key of its row. */
  window(key: string): RowWindow {
    return this.windows.get(key) ?? { first: 0, end: ROWS_PER_STEP };
  }

  /** Shows more targets, next to the given one, which is the first hidden one. */
  expand(key: string, target: number): void {
    const { first, end } = this.window(key);
    this.windows.set(key, target < first ? { first: Math.max(first - ROWS_PER_STEP, 0), end } : { first, end: end + ROWS_PER_STEP });
  }

  /** Shows a target, with its neighbours if it was not shown. */
  reveal(key: string, target: number): void {
    const { first, end } = this.window(key);
    if (target >= first && target < end) return;
    const begin = Math.max(target - ROWS_PER_STEP / 2, 0);
    this.windows.set(key, { first: begin, end: begin + ROWS_PER_STEP });
  }
}

const defaultRow = { below: -1, open: false, motion: null, target: null, more: 0, error: "" };

function* childRows(displayed: DisplayedPath, state: TreeState, parent: TreeRow, errors: Map<string, string>): Generator<TreeRow> {
  const { targets } = displayed.file.paths[parent.below];
  const { first, end } = state.window(parent.key);
  const more = (target: number, count: number) => {
    const place = { path: parent.below, target };
    return { ...defaultRow, key: `${parent.key}/more`, level: parent.level + 1, place, more: count };
  };
  // After targets were removed, a window may begin past the last one.
  const begin = Math.min(first, Math.max(targets.length - ROWS_PER_STEP, 0));
  if (begin > 0) yield more(begin - 1, begin);
  for (let target = begin; target < Math.min(targets.length, end); ++target) {
    const each = targets[target];
    const place = { path: parent.below, target };
    const key = `${parent.key}/${target}`;
    const row = { ...defaultRow, key, level: parent.level + 1, place, target: each, error: errors.get(targetKey(place)) ?? "" };
    if (!isSubPath(each)) {
      yield { ...row, motion: isPoint(each) ? pointMotion(each) : "rapid" };
      continue;
    }
    // A path that leads back to itself is not opened.
    const below = row.error ? -1 : findPathIndex(displayed.file, each.path);
    const sub = { ...row, below, open: below >= 0 && state.isOpen(key) };
    yield sub;
    if (sub.open) yield* childRows(displayed, state, sub, errors);
  }
  if (targets.length > end) yield more(end, targets.length - end);
}

/** Returns all visible rows. */
export function* visibleRows(displayed: DisplayedPath, state: TreeState): Generator<TreeRow> {
  const { file, walk } = displayed;
  const errors = new Map(walk.errors.flatMap(({ place, text }) => (place ? [[targetKey(place), text] as const] : [])));
  const root = Math.max(rootIndex(file), 0);
  const topPaths = [root, ...file.paths.keys()].filter((path, i) => i === 0 || !walk.used.has(path));
  for (const path of topPaths) {
    if (!file.paths[path] || (path === root && topPaths.indexOf(path) > 0)) continue;
    const place = { path, target: -1 };
    const key = String(path);
    const row = { ...defaultRow, key, level: 1, place, below: path, open: state.isOpen(key), error: errors.get(targetKey(place)) ?? "" };
    yield row;
    if (row.open) yield* childRows(displayed, state, row, errors);
  }
}

/** Opens the rows that hide a place, along the first route to it. */
export function reveal({ file, walk }: DisplayedPath, state: TreeState, place: TargetId): void {
  const root = Math.max(rootIndex(file), 0);
  const way = findRoute(file, root, place.path, []) ?? (walk.used.has(place.path) ? null : []);
  if (!way) return;
  let key = String(way.length > 0 || place.path === root ? root : place.path);
  let path = root;
  for (const target of way) {
    open(state, key, target);
    key += `/${target}`;
    path = findPathIndex(file, (file.paths[path].targets[target] as { path: string }).path);
  }
  if (place.target >= 0) open(state, key, place.target);
}

function open(state: TreeState, key: string, target: number): void {
  state.set(key, true);
  state.reveal(key, target);
}

/** Returns the numbers of the targets that lead from one path to another; null: none. */
function findRoute(file: DisplayedPath["file"], from: number, to: number, way: number[], seen = new Set<number>()): number[] | null {
  if (from === to) return way;
  if (seen.has(from)) return null;
  seen.add(from);
  const targets = file.paths[from]?.targets ?? [];
  for (let i = 0; i < targets.length; ++i) {
    const each = targets[i];
    if (!isSubPath(each)) continue;
    const below = findPathIndex(file, each.path);
    const found = below < 0 ? null : findRoute(file, below, to, [...way, i], seen);
    if (found) return found;
  }
  return null;
}

/** True if a row represents a place. */
export const isRowForTarget = (row: TreeRow, place: TargetId | null): boolean => row.more === 0 && isSameTarget(row.place, place);

// Walk through a path file: the motion to each point, the values that the point inherits from those before
// it, and errors there.

import { texts } from "../../texts";
import { arcTo, type Arc } from "./path_arc";
import { findPathIndex, isMachinePoint, isSubPath, targetKey, pointMotion, rootIndex, type Error, type PathFile, type TargetId, type Point, type SubPath } from "./path_file";
import type { Vector } from "./vector";

/** Max nesting depth of sub-paths; the root is not counted. */
const MAX_DEPTH = 8;
const words = texts.paths.errors;

type Orientation = Pick<Point, "tool_axis" | "rpy_deg" | "rotary_deg">;

/** Values that points inherit from those before. */
export interface State extends Orientation {
  position_mm?: Vector;
  /** Point of the position. */
  at?: TargetId;
  /** True if the machine is at a fixed or reference point, so that the position is unknown. */
  atMachinePoint?: boolean;
  feed_mm_min?: number;
  feed_deg_min?: number;
  feed_mm_rev?: number;
  work_offset?: string;
  acceleration_mm_s2?: number;
}

/** A motion to a point. */
export interface Motion {
  place: TargetId;
  /** Previous point of the tool, and its position; null: not defined. */
  after: TargetId | null;
  from_mm: Vector | null;
  to_mm: Vector;
  rapid: boolean;
  arc: Arc | null;
}

export interface PathTraversal {
  motions: Motion[];
  /** State before each point, by targetKey. */
  before: Map<string, State>;
  /** Numbers of the paths that the root leads to. */
  used: Set<number>;
  errors: Error[];
}

/** Returns the state after a point, or after all settings of a path. */
export function stateAfter(before: State, later: State): State {
  const turning = later.tool_axis ?? later.rpy_deg ?? later.rotary_deg ? later : before;
  const feedState = later.feed_mm_min !== undefined ? later : before;
  // Members are copied one by one, for speed: paths may have very many points.
  const standing = later.position_mm || later.atMachinePoint ? later : before;
  return {
    position_mm: standing.position_mm,
    at: later.at ?? before.at,
    atMachinePoint: standing.atMachinePoint,
    tool_axis: turning.tool_axis,
    rpy_deg: turning.rpy_deg,
    rotary_deg: turning.rotary_deg,
    feed_mm_min: feedState.feed_mm_min,
    feed_mm_rev: feedState.feed_mm_rev,
    feed_deg_min: later.feed_deg_min ?? before.feed_deg_min,
    work_offset: later.work_offset ?? before.work_offset,
    acceleration_mm_s2: later.acceleration_mm_s2 ?? before.acceleration_mm_s2,
  };
}

class Walker {
  readonly walk: PathTraversal = { motions: [], before: new Map(), used: new Set(), errors: [] };
  /** Settings of each path that was already walked. */
  private readonly changes = new Map<number, State>();
  /** Entries into walked paths: first point, and previous position of the tool. */
  private readonly visited = new Set<string>();
  private readonly targetsWithErrors = new Set<string>();

  constructor(private readonly file: PathFile) {}

  all(): PathTraversal {
    const { file, walk } = this;
    const names = new Set<string>();
    file.paths.forEach(({ name }, path) => {
      if (names.has(name)) this.fail({ path, target: -1 }, words.twice(name));
      names.add(name);
    });
    const root = rootIndex(file);
    if (root < 0) walk.errors.push({ text: words.noPath(file.root!), place: null });
    else this.enter(root, {}, []);
    walk.used = new Set(this.changes.keys());
    // Unused paths are drawn, too: the user may be about to use them.
    file.paths.forEach((_, path) => {
      if (!this.changes.has(path)) this.enter(path, {}, []);
    });
    return walk;
  }

  private fail(place: TargetId, text: string): void {
    const key = targetKey(place);
    if (this.targetsWithErrors.has(key)) return;
    this.targetsWithErrors.add(key);
    this.walk.errors.push({ text, place });
  }

  /** Walks through a path for the first time; returns the state after it. */
  private enter(path: number, state: State, way: number[]): State {
    let change: State = {};
    this.file.paths[path].targets.forEach((target, i) => {
      const place = { path, target: i };
      if (isSubPath(target)) {
        const below = this.follow(place, target, state, [...way, path]);
        change = stateAfter(change, below);
        state = stateAfter(state, below);
      } else if (isMachinePoint(target)) {
        const behind: State = { atMachinePoint: true, at: place };
        change = stateAfter(change, behind);
        state = stateAfter(state, behind);
      } else {
        this.go(place, target, state, way.length === 0);
        change = stateAfter(change, target);
        state = stateAfter(state, target);
        state.at = change.at = place;
      }
    });
    this.changes.set(path, change);
    return state;
  }

  /** Returns the settings of a sub-path. */
  private follow(place: TargetId, { path: name, repeats = 1 }: SubPath, state: State, way: number[]): State {
    const path = findPathIndex(this.file, name);
    if (path < 0) this.fail(place, words.noPath(name));
    else if (way.includes(path)) this.fail(place, words.circle(name));
    else if (way.length > MAX_DEPTH) this.fail(place, words.tooDeep(MAX_DEPTH));
    else {
      if (this.changes.has(path)) this.addEntry(path, state);
      else this.enter(path, state, way);
      const change = this.changes.get(path)!;
      // Each pass after the first starts at the path's own end.
      if (repeats > 1) this.addEntry(path, stateAfter(state, change));
      return change;
    }
    return {};
  }

  /** Adds another entry into a walked path: only its first motion differs. */
  private addEntry(path: number, state: State, depth = 0): void {
    const [first] = this.file.paths[path].targets;
    const place = { path, target: 0 };
    if (isMachinePoint(first)) return;
    if (!isSubPath(first)) return this.go(place, first, state, false);
    const below = findPathIndex(this.file, first.path);
    if (depth < MAX_DEPTH && this.changes.has(below)) this.addEntry(below, state, depth + 1);
  }

  private go(place: TargetId, point: Point, state: State, isOutermost: boolean): void {
    const key = targetKey(place);
    if (!this.walk.before.has(key)) this.walk.before.set(key, state);
    const from_mm = state.position_mm ?? null;
    if (place.target === 0) {
      const way = `${key} ${from_mm} ${state.atMachinePoint}`;
      if (this.visited.has(way)) return;
      this.visited.add(way);
    }
    const motion = pointMotion(point);
    let arc: Arc | null = null;
    if (state.atMachinePoint && motion !== "rapid") this.fail(place, words.rapidBehindPoint);
    else if (motion === "circular") {
      const shape = from_mm ? arcTo(from_mm, point) : isOutermost ? words.firstIsArc : null;
      if (typeof shape === "string") this.fail(place, shape);
      else arc = shape;
    }
    if (motion === "none") return;
    const after = state.at ?? null;
    this.walk.motions.push({ place, after, from_mm, to_mm: point.position_mm, rapid: motion === "rapid", arc });
  }
}

export const traversePath = (file: PathFile): PathTraversal => new Walker(file).all();

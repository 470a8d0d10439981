// State of the page: a value for each key, and listeners to its changes.

import type { TargetId } from "../run/path/path_file";
import type { SourceLocation } from "../run/report";
import type { Run } from "../run/run";
import type { DisplayedPath } from "./displayed_path";

export type ColourMode = "kind" | "feed" | "speed" | "process" | "time" | "limit" | "deviation";
export type Units = "mm" | "inch";
export type Theme = "light" | "dark";

/** How a run is going. */
export interface Running {
  /** Blocks done, of `total` (0: not known). */
  done: number;
  total: number;
}

/** Run that is compared with the shown one, on the same clock. */
export interface ComparisonRun {
  run: Run;
  /** Names of both: the shown run, and this one. */
  names: readonly [string, string];
}

/** Object in the view that can be moved by hand. */
export interface Handle {
  /** Owner of the handle. */
  owner: object;
  /** Frame that it is attached to, in the world of the run (mm), column by column. */
  parent: number[];
  /** Its pose in that frame. */
  pose: number[];
  /** Frame in the scene of the shown robot that carries the bodies there; -1: none. */
  frame: number;
  /** Called on release at another pose in that frame. */
  moved(pose: number[]): void;
}

export interface State {
  /** Shown run, and the previous one for comparison. */
  run: Run | null;
  previous: Run | null;
  /** Comparison run; null: the view shows a single run. */
  comparisonRun: ComparisonRun | null;
  /** Run of many segments in progress: the part received so far, and its number of segments. */
  partialRun: { run: Run; count: number } | null;
  /** Counter that increases when more of the shown run is loaded. */
  loadCount: number;
  /** Run in progress; null: none. */
  running: Running | null;
  /** Shown instant, in seconds of the run. */
  time_s: number;
  playing: boolean;
  /** Seconds of the run per second. */
  rate: number;
  /** Robot that has its segments shown in charts and tables. */
  robot: number;
  /** Selection of the user: a line, and the number of one of its blocks (-1: none in particular). */
  selection: (SourceLocation & { block: number }) | null;
  colour: ColourMode;
  units: Units;
  theme: Theme;
  perspective: boolean;
  follow: boolean;
  showEnvelope: boolean;
  showZones: boolean;
  showRapids: boolean;
  showDirections: boolean;
  measuring: boolean;
  compare: boolean;
  /** Name of the document in the editor. */
  document: string;
  /** Path file that is edited (empty: none), its shown state, and its selected point. */
  pathFile: string;
  path: DisplayedPath | null;
  pathPoint: TargetId | null;
  /** True if the view shows its points. */
  showPath: boolean;
  /** Joints of the shown robot (mm, rad) in place of those at the shown instant. */
  jog: ArrayLike<number> | null;
  /** Name of the file of variants that is edited; empty: none. */
  variantsFile: string;
  /** True if that form is requested to show its data of the selected line. */
  isBlockPanelRequested: boolean;
  /** Name of a requested form, and a drawing to make a path from; empty: none. */
  form: string;
  drawing: string;
  /** Source location that the code is requested to show, in any kind of text; null: none. */
  requestedLocation: SourceLocation | null;
  /** Body that was clicked on in the view; null: none. */
  body: string | null;
  /** Handle in the view; null: none. */
  handle: Handle | null;
  /** Message to the user of the page; empty: none. */
  notice: string;
}

type Listener<K extends keyof State> = (value: State[K], before: State[K]) => void;

export class Store {
  private readonly listeners = new Map<keyof State, Set<Listener<never>>>();

  constructor(private readonly state: State) {}

  get<K extends keyof State>(key: K): State[K] {
    return this.state[key];
  }

  /** Sets a value and notifies listeners if it has changed. */
  set<K extends keyof State>(key: K, value: State[K]): void {
    const before = this.state[key];
    if (Object.is(before, value)) return;
    this.state[key] = value;
    for (const listener of this.listeners.get(key) ?? []) (listener as Listener<K>)(value, before);
  }

  /** Returns what ends the listening. */
  on<K extends keyof State>(key: K, listener: Listener<K>): () => void {
    const all = this.listeners.get(key) ?? new Set();
    this.listeners.set(key, all);
    all.add(listener as Listener<never>);
    return () => all.delete(listener as Listener<never>);
  }

  /** Calls `listener` at once, and on each change of one of the keys. */
  watch(keys: (keyof State)[], listener: () => void): void {
    for (const key of keys) this.on(key, listener);
    listener();
  }
}

export const initialState = (): State => ({
  run: null,
  previous: null,
  comparisonRun: null,
  partialRun: null,
  loadCount: 0,
  running: null,
  time_s: 0,
  playing: false,
  rate: 1,
  robot: 0,
  selection: null,
  colour: "kind",
  units: "mm",
  theme: "light",
  perspective: true,
  follow: false,
  showEnvelope: false,
  showZones: true,
  showRapids: true,
  showDirections: true,
  measuring: false,
  compare: false,
  document: "",
  pathFile: "",
  path: null,
  pathPoint: null,
  showPath: false,
  jog: null,
  variantsFile: "",
  isBlockPanelRequested: false,
  form: "",
  drawing: "",
  requestedLocation: null,
  body: null,
  handle: null,
  notice: "",
});

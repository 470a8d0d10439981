// The state of the page: a value for each key, and who wants to know when one changes.

import type { Place as PathPlace } from "../run/path/path_file";
import type { Place } from "../run/report";
import type { Run } from "../run/run";
import type { PathShown } from "./path_shown";

export type ColourMode = "kind" | "feed" | "speed" | "process" | "time" | "limit" | "deviation";
export type Units = "mm" | "inch";
export type Theme = "light" | "dark";

/** How a run is going. */
export interface Running {
  /** Blocks done, of `total` (0: not known). */
  done: number;
  total: number;
}

/** A run beside the one that is shown, on the same clock. */
export interface Beside {
  run: Run;
  /** What both are called: the one that is shown, and this one. */
  names: readonly [string, string];
}

/** What may be moved by hand in the view. */
export interface Handle {
  /** Whose it is. */
  owner: object;
  /** The frame that it is attached to, in the world of the run (mm); columns one behind the other. */
  parent: number[];
  /** Where it stands there. */
  pose: number[];
  /** Of the scene of the robot that is shown: the frame whose bodies stand there; -1: none. */
  frame: number;
  /** Let go, at another place there. */
  moved(pose: number[]): void;
}

export interface State {
  /** The run that is shown, and the one before it, for comparing. */
  run: Run | null;
  previous: Run | null;
  /** Null: the view has one run alone. */
  beside: Beside | null;
  /** A run of many segments that is under way: what there is of it, and how many that is. */
  growing: { run: Run; count: number } | null;
  /** Goes up when more of the run that is shown is here. */
  fetched: number;
  /** A run that is under way, null: none. */
  running: Running | null;
  /** The instant that is shown, in seconds of the run. */
  time_s: number;
  playing: boolean;
  /** Seconds of the run in one second. */
  rate: number;
  /** Whose segments are shown in charts and tables. */
  robot: number;
  /** What a person has chosen: a line, and of its blocks the one by number (-1: none in particular). */
  selection: (Place & { block: number }) | null;
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
  /** The name of the document that the editor shows. */
  document: string;
  /** The path file that is worked on (empty: none), it as it is shown, and which of its points is chosen. */
  pathFile: string;
  path: PathShown | null;
  pathPoint: PathPlace | null;
  /** Whether the view has its points. */
  showPath: boolean;
  /** Of the robot that is shown: joints (mm, rad) in place of those of the instant. */
  jog: ArrayLike<number> | null;
  /** The name of the file of variants that is worked on; empty: none. */
  variantsFile: string;
  /** That form is asked what it has of the chosen line. */
  hereAsked: boolean;
  /** A form that is asked for by its name, and a drawing that a path is to be made of; empty: none. */
  form: string;
  drawing: string;
  /** A place in a file that the code is asked to show, whatever kind of text it is; null: none. */
  textAsked: Place | null;
  /** A body that was clicked on in the view; null: none. */
  body: string | null;
  /** In the view; null: none. */
  handle: Handle | null;
  /** A sentence to who uses the page; empty: none. */
  notice: string;
}

type Listener<K extends keyof State> = (value: State[K], before: State[K]) => void;

export class Store {
  private readonly listeners = new Map<keyof State, Set<Listener<never>>>();

  constructor(private readonly state: State) {}

  get<K extends keyof State>(key: K): State[K] {
    return this.state[key];
  }

  /** Tells listeners where the value is another one. */
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

  /** Calls at once, and on each change of one of the keys. */
  watch(keys: (keyof State)[], listener: () => void): void {
    for (const key of keys) this.on(key, listener);
    listener();
  }
}

export const initialState = (): State => ({
  run: null,
  previous: null,
  beside: null,
  growing: null,
  fetched: 0,
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
  hereAsked: false,
  form: "",
  drawing: "",
  textAsked: null,
  body: null,
  handle: null,
  notice: "",
});

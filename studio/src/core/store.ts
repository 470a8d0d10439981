// The state of the page: a value for each key, and who wants to know when one changes.

import type { Place } from "../run/report";
import type { Run } from "../run/run";

export type ColourMode = "kind" | "feed" | "speed" | "process" | "time" | "limit" | "deviation";
export type Units = "mm" | "inch";
export type Theme = "light" | "dark";

/** How a run is going. */
export interface Running {
  /** Blocks done, of `total` (0: not known). */
  done: number;
  total: number;
}

export interface State {
  /** The run that is shown, and the one before it, for comparing. */
  run: Run | null;
  previous: Run | null;
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
  notice: "",
});

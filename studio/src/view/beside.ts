// The view of a run beside the one that is shown: a half of the room each, one clock, and eyes that move together.

import "./beside.css";
import { Matrix4, Vector3 } from "three";
import { element } from "../core/dom";
import { initialState, Store, type Beside, type State } from "../core/store";
import type { Robot } from "../run/run";
import { texts } from "../texts";
import { createView, type ViewParts } from ".";
import { noBeside, type BesidePlace, type CreateBeside } from "./beside_place";
import { noHeadset } from "./headset_place";
import { noHolds } from "./holds";
import type { View } from "./view";

/** What both show alike. */
const common = [
  ...(["time_s", "playing", "robot", "colour", "units", "theme", "perspective", "follow"] as const),
  ...(["showZones", "showRapids", "showDirections"] as const),
];

type Selection = State["selection"];

/** A block of one machine's run as the other's has it: that of the same line, at the same pass over it. */
function selectionIn(selection: Selection, from: Robot | undefined, to: Robot | undefined): Selection {
  if (!selection || selection.block < 0) return selection;
  const { file, line } = selection;
  const pass = from?.blocks.ofLine(from.files.indexOf(file), line).indexOf(selection.block) ?? -1;
  return { file, line, block: to?.blocks.ofLine(to.files.indexOf(file), line)[pass] ?? -1 };
}

/** While both are seen a change of one store is one of the other: what is the same there is told to nobody, so that this ends. */
class Joined {
  private passing = false;

  constructor(
    private readonly main: Store,
    private readonly other: Store,
    private readonly areBoth: () => boolean,
  ) {
    for (const [from, to] of [[main, other], [other, main]]) {
      for (const key of common) from.on(key, () => this.areBoth() && this.pass(key, from, to));
      from.on("selection", () => this.areBoth() && this.select(from, to));
    }
  }

  /** The other one is as the main one is. */
  begin(): void {
    for (const key of common) this.pass(key, this.main, this.other);
    this.select(this.main, this.other);
  }

  private pass<K extends keyof State>(key: K, from: Store, to: Store): void {
    to.set(key, from.get(key));
  }

  private select(from: Store, to: Store): void {
    if (this.passing) return;
    const robotOf = (store: Store) => store.get("run")?.robots[store.get("robot")];
    this.passing = true;
    to.set("selection", selectionIn(from.get("selection"), robotOf(from), robotOf(to)));
    this.passing = false;
  }
}

/** Where the work stands in the world: both eyes look at their own. */
const workOf = (view: View): Vector3 => new Vector3().setFromMatrixPosition(view.shown?.work ?? new Matrix4());

/** Neither eye moves without the other while both are seen. */
class Eyes {
  private passing = false;

  constructor(
    one: View,
    other: View,
    private readonly areBoth: () => boolean,
  ) {
    one.watchers.add(() => this.pass(one, other));
    other.watchers.add(() => this.pass(other, one));
  }

  /** What happens to one of them meanwhile is not passed on. */
  still(act: () => void): void {
    this.passing = true;
    act();
    this.passing = false;
  }

  private pass(from: View, to: View): void {
    if (this.passing || !this.areBoth()) return;
    this.still(() => {
      to.rig.lookAs(from.rig, workOf(to).sub(workOf(from)));
      to.turned();
    });
  }
}

/** The other view goes without what leads on from the one. */
const alone: ViewParts = { createHolds: noHolds, createHeadset: noHeadset, createBeside: noBeside };

class BesideView {
  private readonly store = new Store(initialState());
  private readonly half = element("div", { class: "beside", "aria-label": texts.variants.besideView });
  private readonly names = [0, 1].map((i) => element("div", { class: `side-name side-name-${i}` }));
  private joined: { stores: Joined; eyes: Eyes } | null = null;

  constructor(private readonly place: BesidePlace) {
    const { host, store } = place;
    host.append(this.half, ...this.names);
    store.watch(["beside"], () => this.show(store.get("beside")));
  }

  private show(beside: Beside | null): void {
    const { host, view } = this.place;
    host.classList.toggle("split", beside !== null);
    this.names.forEach((each, i) => (each.textContent = beside?.names[i] ?? ""));
    if (!beside) return this.store.set("run", null);
    this.joined ??= this.make();
    this.joined?.eyes.still(() => {
      this.store.set("run", beside.run);
      this.joined!.stores.begin();
    });
    // Both canvases have their new sizes in the second frame from here.
    requestAnimationFrame(() => requestAnimationFrame(() => view.fit(false)));
  }

  /** Not before it is asked for: a second picture takes a second part of the graphics card. */
  private make(): { stores: Joined; eyes: Eyes } | null {
    const { view, store, session, frames } = this.place;
    const second = createView(this.half, this.store, session, frames, alone);
    if (!second) return null;
    const areBoth = () => store.get("beside") !== null;
    return { stores: new Joined(store, this.store, areBoth), eyes: new Eyes(view, second.view, areBoth) };
  }
}

export const createBeside: CreateBeside = (place) => {
  new BesideView(place);
};

// View of a comparison run next to the shown one: half of the area each, one clock, and cameras that move
// together.

import "./comparison_view.css";
import { Matrix4, Vector3 } from "three";
import { element } from "../core/dom";
import { initialState, Store, type ComparisonRun, type State } from "../core/store";
import type { Robot } from "../run/run";
import { texts } from "../texts";
import { createView, type ViewParts } from ".";
import { noComparisonView, type ComparisonViewContext, type CreateComparisonView } from "./comparison_view_context";
import { noHeadset } from "./headset_context";
import { noDraggables } from "./draggables";
import type { View } from "./view";

/** What both show alike. */
const common = [
  ...(["time_s", "playing", "robot", "colour", "units", "theme", "perspective", "follow"] as const),
  ...(["showZones", "showRapids", "showDirections"] as const),
];

type Selection = State["selection"];

/** Converts a block of one machine's run to that of the other: same line, same pass over it. */
function convertSelection(selection: Selection, from: Robot | undefined, to: Robot | undefined): Selection {
  if (!selection || selection.block < 0) return selection;
  const { file, line } = selection;
  const pass = from?.blocks.blocksOfLine(from.files.indexOf(file), line).indexOf(selection.block) ?? -1;
  return { file, line, block: to?.blocks.blocksOfLine(to.files.indexOf(file), line)[pass] ?? -1 };
}

/**
 * Copies changes between both stores while both views are visible. Equal values notify no listener, so this
 * ends.
 */
class StoreSync {
  private isSynchronizing = false;

  constructor(
    private readonly main: Store,
    private readonly other: Store,
    private readonly areBothVisible: () => boolean,
  ) {
    for (const [from, to] of [[main, other], [other, main]]) {
      for (const key of common) from.on(key, () => this.areBothVisible() && this.pass(key, from, to));
      from.on("selection", () => this.areBothVisible() && this.select(from, to));
    }
  }

  /** Copies the state of the main one to the other. */
  begin(): void {
    for (const key of common) this.pass(key, this.main, this.other);
    this.select(this.main, this.other);
  }

  private pass<K extends keyof State>(key: K, from: Store, to: Store): void {
    to.set(key, from.get(key));
  }

  private select(from: Store, to: Store): void {
    if (this.isSynchronizing) return;
    const shownRobot = (store: Store) => store.get("run")?.robots[store.get("robot")];
    this.isSynchronizing = true;
    to.set("selection", convertSelection(from.get("selection"), shownRobot(from), shownRobot(to)));
    this.isSynchronizing = false;
  }
}

/** Returns the position of the work in the world: each camera looks at its own. */
const workPosition = (view: View): Vector3 => new Vector3().setFromMatrixPosition(view.displayed?.work ?? new Matrix4());

/** Both cameras, which move only together while both views are visible. */
class CameraSync {
  private isSynchronizing = false;

  constructor(
    one: View,
    other: View,
    private readonly areBothVisible: () => boolean,
  ) {
    one.cameraListeners.add(() => this.pass(one, other));
    other.cameraListeners.add(() => this.pass(other, one));
  }

  /** Runs `act` without passing on changes of one camera. */
  withoutSync(act: () => void): void {
    this.isSynchronizing = true;
    act();
    this.isSynchronizing = false;
  }

  private pass(from: View, to: View): void {
    if (this.isSynchronizing || !this.areBothVisible()) return;
    this.withoutSync(() => {
      to.rig.copyFrom(from.rig, workPosition(to).sub(workPosition(from)));
      to.turned();
    });
  }
}

/** The other view has none of the parts that lead on from the main one. */
const noViewParts: ViewParts = { createDraggables: noDraggables, createHeadset: noHeadset, createComparisonView: noComparisonView };

class ComparisonView {
  private readonly store = new Store(initialState());
  private readonly half = element("div", { class: "beside", "aria-label": texts.variants.secondView });
  private readonly names = [0, 1].map((i) => element("div", { class: `side-name side-name-${i}` }));
  private joined: { stores: StoreSync; eyes: CameraSync } | null = null;

  constructor(private readonly place: ComparisonViewContext) {
    const { host, store } = place;
    host.append(this.half, ...this.names);
    store.watch(["comparisonRun"], () => this.show(store.get("comparisonRun")));
  }

  private show(comparisonRun: ComparisonRun | null): void {
    const { host, view } = this.place;
    host.classList.toggle("split", comparisonRun !== null);
    this.names.forEach((each, i) => (each.textContent = comparisonRun?.names[i] ?? ""));
    if (!comparisonRun) return this.store.set("run", null);
    this.joined ??= this.make();
    this.joined?.eyes.withoutSync(() => {
      this.store.set("run", comparisonRun.run);
      this.joined!.stores.begin();
    });
    // Both canvases have their new sizes in the second frame from here.
    requestAnimationFrame(() => requestAnimationFrame(() => view.fit(false)));
  }

  /** Created on first use: a second picture takes more of the graphics card. */
  private make(): { stores: StoreSync; eyes: CameraSync } | null {
    const { view, store, session, frames } = this.place;
    const second = createView(this.half, this.store, session, frames, noViewParts);
    if (!second) return null;
    const areBothVisible = () => store.get("comparisonRun") !== null;
    return { stores: new StoreSync(store, this.store, areBothVisible), eyes: new CameraSync(view, second.view, areBothVisible) };
  }
}

export const createComparisonView: CreateComparisonView = (place) => {
  new ComparisonView(place);
};

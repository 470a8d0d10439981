// View of a run: machine, path, and the actions on them.

import "./view.css";
import type { AnimationFrames } from "../core/animation_frames";
import { element } from "../core/dom";
import type { Session } from "../core/session";
import type { Store } from "../core/store";
import { texts } from "../texts";
import type { CreateComparisonView } from "./comparison_view_context";
import type { StandardView } from "./camera";
import { Canvas } from "./canvas";
import { listenToGestures } from "./gestures";
import { createLayers } from "./layers";
import { PointerController } from "./pointer_controller";
import type { CreateHeadset } from "./headset_context";
import type { CreateDraggables } from "./draggables";
import { createToolbar, keysOf, listenToKeys, type Actions } from "./toolbar";
import { View } from "./view";
import { watchEnvelope } from "./envelope_loader";

/** Parts of the view that not every page has. */
export interface ViewParts {
  createDraggables: CreateDraggables;
  createHeadset: CreateHeadset;
  createComparisonView: CreateComparisonView;
}

/** For tests, and for the curious. */
export interface ViewHandle {
  readonly view: View;
  fit(all?: boolean): void;
  setStandardView(name: StandardView): void;
  orbit(dx_px: number, dy_px: number): void;
  /** Returns the time until a frame is drawn, ms. */
  measureFrame_ms(kind: "rest" | "orbit" | "empty"): number;
  /** True if the complete path is in the kept picture. */
  complete(): boolean;
  /** Returns the position of a point of the work (mm, of the chosen robot) in the window, in pixels. */
  screenPosition(point_mm: [number, number, number]): [number, number];
}

/** Returns null if WebGL 2 is missing, after showing a message. */
export function createView(
  host: HTMLElement,
  store: Store,
  session: Session,
  frames: AnimationFrames,
  parts: ViewParts,
): ViewHandle | null {
  const surface = element("div", { class: "surface", tabindex: 0, role: "application", "aria-label": texts.view.label });
  const hint = element("div", { class: "hint", role: "status" });
  host.append(surface);
  let view: View | null = null;
  const canvas = Canvas.make(surface, {
    onResized: () => view?.onResized(),
    lost: () => (hint.textContent = texts.view.lost),
    restored: () => {
      hint.textContent = "";
      view?.restored();
    },
  });
  if (!canvas) {
    surface.replaceWith(element("p", { class: "none", role: "alert" }, texts.view.noWebgl));
    return null;
  }
  view = new View(canvas, store, session, parts.createDraggables);
  watchEnvelope(store, session, view, (text) => (hint.textContent = text));
  const pointerController = new PointerController(view, store, hint);
  const act = viewActions(view, store);
  surface.append(canvas.element, view.labels.element, pointerController.tooltip.element);
  const toolbar = createToolbar(store, act, createLayers(store, view.own, () => view.invalidate()));
  host.append(toolbar);
  host.append(view.legend.element, view.triad.element, hint);
  listenToGestures(surface, pointerController);
  listenToKeys(surface, keysOf(store, act));
  // The surface handles Escape while measuring.
  store.on("measuring", (isOn) => isOn && surface.focus({ preventScroll: true }));
  view.onResized();
  void parts.createHeadset({ view, store, frames, toolbar });
  parts.createComparisonView({ host, view, store, session, frames });
  return {
    view,
    fit: (all = false) => view.fit(all),
    setStandardView: (name) => view.setStandardView(name),
    orbit: act.orbit,
    measureFrame_ms: (kind) => view.measureFrame_ms(kind),
    complete: () => view.layer.complete,
    screenPosition: (point_mm) => view.screenOf(point_mm),
  };
}

function viewActions(view: View, store: Store): Actions {
  const { rig } = view;
  const moved = <A extends unknown[]>(move: (...by: A) => void) => {
    return (...by: A) => {
      move(...by);
      view.turned();
    };
  };
  return {
    fit: (all) => view.fit(all),
    setStandardView: (name) => view.setStandardView(name),
    orbit: moved((dx, dy) => rig.orbit(dx, dy)),
    pan: moved((dx, dy) => rig.pan(dx, dy)),
    zoom: moved((factor) => rig.zoom(factor)),
    escape: () => {
      if (view.draggables.some((hold) => hold.cancelDrag())) return;
      if (store.get("measuring")) store.set("measuring", false);
      else store.set("selection", null);
    },
  };
}

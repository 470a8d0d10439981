// Buttons of the view, and keys with the same actions while the view has the focus.

import { element } from "../core/dom";
import type { State, Store } from "../core/store";
import { texts } from "../texts";
import type { StandardView } from "./camera";
import { icon, type Icon } from "./icons";

export interface Actions {
  fit(all: boolean): void;
  setStandardView(name: StandardView): void;
  orbit(dx_px: number, dy_px: number): void;
  pan(dx_px: number, dy_px: number): void;
  zoom(factor: number): void;
  /** Ends the current action. */
  escape(): void;
}

type Switch = { [K in keyof State]: State[K] extends boolean ? K : never }[keyof State];
const words = texts.view;

function button(name: Icon, label: string, key: string, press: (event: Event) => void): HTMLButtonElement {
  const title = `${label} (${key})`;
  const attributes = { type: "button", title, "aria-label": label, "aria-keyshortcuts": key, onclick: press };
  return element("button", attributes, icon(name));
}

function bindPressed(store: Store, key: Switch, made: HTMLElement): HTMLElement {
  store.watch([key], () => made.setAttribute("aria-pressed", String(store.get(key))));
  return made;
}

const toggle = (store: Store, key: Switch) => () => store.set(key, !store.get(key));

export function createToolbar(store: Store, act: Actions, layers: HTMLElement): HTMLElement {
  const stands: [StandardView, string][] = [
    ["top", "1"],
    ["front", "2"],
    ["side", "3"],
    ["iso", "4"],
  ];
  return element(
    "div",
    { class: "tools", role: "toolbar", "aria-label": words.tools, "aria-orientation": "vertical" },
    button("fit", words.fit, "F", (event) => act.fit((event as MouseEvent).shiftKey)),
    ...stands.map(([name, key]) => button(name, words.standardViews[name], key, () => act.setStandardView(name))),
    bindPressed(store, "perspective", button("perspective", words.perspective, "P", toggle(store, "perspective"))),
    bindPressed(store, "follow", button("follow", words.follow, "T", toggle(store, "follow"))),
    bindPressed(store, "measuring", button("measure", words.measure, "M", toggle(store, "measuring"))),
    layers,
  );
}

const STEP_PX = 30;

/** Returns keys by KeyboardEvent.key, letters small; a "+" before it: with Shift. */
export function keysOf(store: Store, act: Actions): Record<string, () => void> {
  return {
    1: () => act.setStandardView("top"),
    2: () => act.setStandardView("front"),
    3: () => act.setStandardView("side"),
    4: () => act.setStandardView("iso"),
    f: () => act.fit(false),
    "+f": () => act.fit(true),
    p: toggle(store, "perspective"),
    t: toggle(store, "follow"),
    m: toggle(store, "measuring"),
    arrowleft: () => act.orbit(STEP_PX, 0),
    arrowright: () => act.orbit(-STEP_PX, 0),
    arrowup: () => act.orbit(0, STEP_PX),
    arrowdown: () => act.orbit(0, -STEP_PX),
    "+arrowleft": () => act.pan(STEP_PX, 0),
    "+arrowright": () => act.pan(-STEP_PX, 0),
    "+arrowup": () => act.pan(0, STEP_PX),
    "+arrowdown": () => act.pan(0, -STEP_PX),
    "-": () => act.zoom(1.2),
    "=": () => act.zoom(1 / 1.2),
    "++": () => act.zoom(1 / 1.2),
    "+": () => act.zoom(1 / 1.2),
    escape: () => act.escape(),
  };
}

export function listenToKeys(surface: HTMLElement, keys: Record<string, () => void>): void {
  surface.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const key = event.key.toLowerCase();
    const act = keys[(event.shiftKey ? "+" : "") + key];
    if (!act) return;
    event.preventDefault();
    act();
  });
}

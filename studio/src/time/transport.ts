// Play, steps and speed.

import { choice, element, svgElement } from "../core/dom";
import type { Store } from "../core/store";
import { texts } from "../texts";

const words = texts.time;
const rates = [0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100, 200, 500, 1000];

export interface Actions {
  play(): void;
  start(): void;
  end(): void;
  block(by: 1 | -1): void;
  mark(by: 1 | -1): void;
}

/** Icons, 16 units wide and high. */
const icons = {
  play: "M4 2l10 6-10 6z",
  pause: "M3 2h4v12H3zM9 2h4v12H9z",
  start: "M2 2h2v12H2zM14 2v12L5 8z",
  end: "M12 2h2v12h-2zM2 2v12l9-6z",
  previousBlock: "M11 2v12L3 8z",
  nextBlock: "M5 2v12l8-6z",
  previousMark: "M13 2v12L7 8zM2 8l3-4 3 4-3 4z",
  nextMark: "M3 2v12l6-6zM8 8l3-4 3 4-3 4z",
};

const icon = (name: keyof typeof icons): SVGElement =>
  svgElement("svg", { viewBox: "0 0 16 16", "aria-hidden": "true" }, svgElement("path", { d: icons[name] }));

const button = (name: keyof typeof icons, label: string, click: () => void): HTMLButtonElement =>
  element("button", { class: "icon", "aria-label": label, title: label, onclick: click }, icon(name));

export function createTransport(store: Store, actions: Actions): HTMLElement {
  const play = button("play", words.play, actions.play);
  const options = rates.map((value) => [String(value), `× ${value}`] as const);
  const rate = choice(words.rate, options, String(nearest(store.get("rate"))), (value) => store.set("rate", Number(value)));
  rate.classList.add("rate");
  store.on("rate", (value) => (rate.value = String(nearest(value))));
  store.watch(["playing"], () => {
    const playing = store.get("playing");
    const label = playing ? words.pause : words.play;
    play.replaceChildren(icon(playing ? "pause" : "play"));
    play.title = label;
    play.setAttribute("aria-label", label);
  });
  return element(
    "div",
    { class: "transport", role: "toolbar", "aria-label": words.transport },
    button("start", words.start, actions.start),
    button("previousMark", words.previousMark, () => actions.mark(-1)),
    button("previousBlock", words.previousBlock, () => actions.block(-1)),
    play,
    button("nextBlock", words.nextBlock, () => actions.block(1)),
    button("nextMark", words.nextMark, () => actions.mark(1)),
    button("end", words.end, actions.end),
    rate,
  );
}

/** Returns the step that is nearest on the scale. */
const nearest = (rate: number): number =>
  rates.reduce((best, step) => (Math.abs(Math.log(step / rate)) < Math.abs(Math.log(best / rate)) ? step : best));

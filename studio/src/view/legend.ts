// By what the way is coloured, and what the colours mean.

import { scaleColour } from "../core/colours";
import { make } from "../core/element";
import type { ColourMode, Store, Units } from "../core/store";
import { feedText, lengthText, timeText } from "../core/units";
import { texts } from "../texts";
import { classColour, type Key } from "./path/path_colours";

const words = texts.view;
const STOPS = 9;

const gradient = (): string => {
  const stops = Array.from({ length: STOPS }, (_, i) => {
    const parts = scaleColour(i / (STOPS - 1)).map((part) => Math.round(part * 255));
    return `rgb(${parts.join()})`;
  });
  return `linear-gradient(to right, ${stops.join()})`;
};

const quantityText: Partial<Record<ColourMode, (value: number, units: Units) => string>> = {
  feed: (mm_min, units) => feedText(mm_min / 60, units),
  speed: feedText,
  time: (t_s) => timeText(t_s, 1),
  deviation: lengthText,
};

export class Legend {
  readonly element = make("div", { class: "legend" });
  private readonly list = make("div", { class: "key" });
  private readonly note = make("div", { class: "note" });

  constructor(private readonly store: Store) {
    const choice = make("select", { "aria-label": words.colour, title: words.colour });
    for (const [mode, name] of Object.entries(words.colours)) choice.append(make("option", { value: mode }, name));
    choice.addEventListener("change", () => store.set("colour", choice.value as ColourMode));
    store.watch(["colour"], () => (choice.value = store.get("colour")));
    this.element.append(choice, this.list, this.note);
  }

  show(key: Key | null, gridStep_mm: number): void {
    const units = this.store.get("units");
    this.list.replaceChildren(...(key ? this.entries(key, units) : []));
    this.note.textContent = gridStep_mm > 0 ? `${words.layers.grid} ${lengthText(gridStep_mm, units)}` : "";
  }

  private entries({ mode, scale, classes }: Key, units: Units): HTMLElement[] {
    if (!scale) {
      const names: Record<string, string> = words.classes;
      return classes.map((name) => {
        const swatch = make("i", { style: `background: ${classColour(mode, name)}` });
        return make("span", {}, swatch, names[name] ?? name);
      });
    }
    const text = quantityText[mode]!;
    const ends = make("div", { class: "ends" }, make("span", {}, text(scale.low, units)), make("span", {}, text(scale.high, units)));
    return [make("div", { class: "scale", style: `background: ${gradient()}` }), ends];
  }
}

// Colour mode of the path, and the meaning of the colours.

import { scaleColour } from "../core/colours";
import { choice, element } from "../core/dom";
import type { ColourMode, Store, Units } from "../core/store";
import { feedText, lengthText, timeText } from "../core/units";
import { texts } from "../texts";
import { classColour, type LegendKey } from "./path/path_colours";

const words = texts.view;
const GRADIENT_STOPS = 9;

const gradient = (): string => {
  const stops = Array.from({ length: GRADIENT_STOPS }, (_, i) => {
    const parts = scaleColour(i / (GRADIENT_STOPS - 1)).map((part) => Math.round(part * 255));
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

const classNames: Partial<Record<ColourMode, Record<string, string>>> = {
  kind: texts.run.kinds,
  limit: texts.run.limits,
  process: words.process,
};

export class Legend {
  readonly element = element("div", { class: "legend" });
  private readonly list = element("div", { class: "key" });
  private readonly note = element("div", { class: "note" });

  constructor(private readonly store: Store) {
    const modes = choice(words.colour, Object.entries(words.colours), store.get("colour"), (mode) =>
      store.set("colour", mode as ColourMode),
    );
    store.on("colour", (mode) => (modes.value = mode));
    this.element.append(modes, this.list, this.note);
  }

  show(key: LegendKey | null, gridStep_mm: number): void {
    const units = this.store.get("units");
    this.list.replaceChildren(...(key ? this.entries(key, units) : []));
    this.note.textContent = gridStep_mm > 0 ? `${words.layers.grid} ${lengthText(gridStep_mm, units)}` : "";
  }

  private entries({ mode, scale, classes, isPartial }: LegendKey, units: Units): HTMLElement[] {
    if (!scale) {
      return classes.map((name) => {
        const swatch = element("i", { style: `background: ${classColour(mode, name)}` });
        return element("span", {}, swatch, classNames[mode]?.[name] ?? name);
      });
    }
    const text = quantityText[mode]!;
    const ends = element("div", { class: "ends" }, element("span", {}, text(scale.low, units)), element("span", {}, text(scale.high, units)));
    return [element("div", { class: "scale", style: `background: ${gradient()}` }), ends, ...(isPartial ? [element("div", { class: "note" }, words.partial)] : [])];
  }
}

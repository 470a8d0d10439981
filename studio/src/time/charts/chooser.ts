// Selection of charts, of axes, and of units.

import { axisColour } from "../../core/colours";
import { check, element } from "../../core/dom";
import type { Axis } from "../../run/scene";
import { texts } from "../../texts";
import { chartIds, type ChartId } from "./traces";

const words = texts.time;

export interface ChartSelection {
  charts: ChartId[];
  axes: Set<number>;
  percent: boolean;
}

export interface Chooser {
  element: HTMLElement;
  readonly chosen: ChartSelection;
  /** Starts with another machine and its available charts: all its axes are shown. */
  begin(axes: Axis[], listedOptions: readonly ChartId[]): void;
}

/** Creates a box that is initially checked or not. */
function createCheckbox(label: Node | string, title: string, checked: boolean, change: (on: boolean) => void): HTMLElement {
  const { row, box } = check(label, change, { title });
  box.checked = checked;
  return row;
}

export function createChooser(changed: (chosen: ChartSelection) => void): Chooser {
  const displayed = new Set<ChartId>(["speed"]);
  const hidden = new Set<string>();
  let letters: string[] = [];
  let listedOptions: readonly ChartId[] = [];
  let percent = true;
  const axes = element("div", { class: "axes", role: "group", "aria-label": words.axes });

  const chosen = (): ChartSelection => ({
    charts: listedOptions.filter((id) => displayed.has(id)),
    axes: new Set(letters.flatMap((letter, i) => (hidden.has(letter) ? [] : [i]))),
    percent,
  });
  const put = <T>(set: Set<T>, value: T, on: boolean) => {
    if (on) set.add(value);
    else set.delete(value);
    changed(chosen());
  };
  const charts = chartIds.map((id) =>
    createCheckbox(words.charts[id], words.chartHints[id], displayed.has(id), (on) => put(displayed, id, on)),
  );
  const measure = createCheckbox(words.percent, words.percentHint, percent, (on) => {
    percent = on;
    changed(chosen());
  });
  return {
    element: element("div", { class: "chooser", role: "group", "aria-label": words.chooser }, ...charts, axes, measure),
    get chosen() {
      return chosen();
    },
    begin(all, those) {
      listedOptions = those;
      charts.forEach((row, i) => (row.hidden = !listedOptions.includes(chartIds[i])));
      letters = all.map((axis) => axis.letter);
      axes.replaceChildren(
        ...letters.map((letter, i) => {
          const name = element("span", { style: `--colour:${axisColour(i)}` }, letter);
          return createCheckbox(name, words.axisHint(letter), !hidden.has(letter), (on) => put(hidden, letter, !on));
        }),
      );
    },
  };
}

// Selection of charts, of axes, and of units.

import { axisColour } from "../../core/colours";
import { check, element } from "../../core/dom";
import type { Axis } from "../../run/scene";
import { texts } from "../../texts";
import { chartIds, type ChartId } from "./traces";

const words = texts.time;

export interface Chosen {
  charts: ChartId[];
  axes: Set<number>;
  percent: boolean;
}

export interface Chooser {
  element: HTMLElement;
  readonly chosen: Chosen;
  /** Starts with another machine and its available charts: all its axes are shown. */
  begin(axes: Axis[], offered: readonly ChartId[]): void;
}

/** Creates a box that is initially checked or not. */
function tick(label: Node | string, title: string, checked: boolean, change: (on: boolean) => void): HTMLElement {
  const { row, box } = check(label, change, { title });
  box.checked = checked;
  return row;
}

export function createChooser(changed: (chosen: Chosen) => void): Chooser {
  const shown = new Set<ChartId>(["speed"]);
  const hidden = new Set<string>();
  let letters: string[] = [];
  let offered: readonly ChartId[] = [];
  let percent = true;
  const axes = element("div", { class: "axes", role: "group", "aria-label": words.axes });

  const chosen = (): Chosen => ({
    charts: offered.filter((id) => shown.has(id)),
    axes: new Set(letters.flatMap((letter, i) => (hidden.has(letter) ? [] : [i]))),
    percent,
  });
  const put = <T>(set: Set<T>, value: T, on: boolean) => {
    if (on) set.add(value);
    else set.delete(value);
    changed(chosen());
  };
  const charts = chartIds.map((id) =>
    tick(words.charts[id], words.chartHints[id], shown.has(id), (on) => put(shown, id, on)),
  );
  const measure = tick(words.percent, words.percentHint, percent, (on) => {
    percent = on;
    changed(chosen());
  });
  return {
    element: element("div", { class: "chooser", role: "group", "aria-label": words.chooser }, ...charts, axes, measure),
    get chosen() {
      return chosen();
    },
    begin(all, those) {
      offered = those;
      charts.forEach((row, i) => (row.hidden = !offered.includes(chartIds[i])));
      letters = all.map((axis) => axis.letter);
      axes.replaceChildren(
        ...letters.map((letter, i) => {
          const name = element("span", { style: `--colour:${axisColour(i)}` }, letter);
          return tick(name, words.axisHint(letter), !hidden.has(letter), (on) => put(hidden, letter, !on));
        }),
      );
    },
  };
}

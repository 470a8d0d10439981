// Charts below the scrubber, and the selection of their contents.

import { element } from "../../core/dom";
import { robotOf } from "../../core/shown";
import type { Store } from "../../core/store";
import { onTheme } from "../../core/theme";
import type { Mark } from "../../run/marks";
import type { Robot } from "../../run/run";
import type { Series, SeriesKind } from "../../run/series";
import { texts } from "../../texts";
import type { TimeWindow } from "../window";
import { LEFT_PX, RIGHT_PX, Chart } from "./chart";
import { createChooser, type Chosen } from "./chooser";
import { curvesOf, type Curves } from "./curves";
import { Leaves } from "./leaves";
import { fetchWithin, isTooMuch, overviewOf } from "./overview";
import type { Group } from "./probe";
import { seriesCurves } from "./series_curves";
import { chartsOf, short, sourceOf, tracesOf, type ChartId } from "./traces";

const LEAST_HEIGHT_PX = 100;

export interface Charts {
  chooser: HTMLElement;
  list: HTMLElement;
  /** Of another run or robot. */
  begin(marks: readonly Mark[]): void;
}

export function createCharts(store: Store, window: TimeWindow): Charts {
  const list = element("div", { class: "charts" });
  const empty = element("p", { class: "hint" }, texts.time.noChart);
  const about = element("p", { class: "hint rough", role: "status", hidden: true });
  let charts: { id: ChartId; chart: Chart }[] = [];
  let violations_s: number[] = [];
  let excesses_s: number[] = [];
  let robot: Robot | undefined;
  let leaves = new Map<Group, Leaves>();
  let hover_s: number | null = null;
  let frame = 0;

  const later = (what: () => void) => {
    cancelAnimationFrame(frame);
    frame = requestAnimationFrame(what);
  };
  const leavesOf = (group: Group): Leaves => {
    const known = leaves.get(group);
    if (known) return known;
    const made = new Leaves(robot!.segments, group, () => made === leaves.get(group) && later(draw));
    leaves.set(group, made);
    return made;
  };

  /** Returns null for data that comes from laws. */
  const seriesOf = (source: Group | SeriesKind): Series | null => robot?.series.get(source as SeriesKind) ?? null;

  function build(chosen: Chosen): void {
    for (const { chart } of charts) chart.destroy();
    charts = [];
    empty.hidden = !robot || chosen.charts.length > 0;
    if (!robot) return;
    const actions = {
      choose: (t_s: number) => store.set("time_s", Math.min(Math.max(t_s, 0), window.whole_s)),
      hover: (t_s: number | null) => {
        hover_s = t_s;
        point();
      },
    };
    for (const id of chosen.charts) {
      const traces = tracesOf(id, robot, { ...chosen, units: store.get("units") });
      if (traces.length === 0) continue;
      const marks_s = id === "effort" ? excesses_s : violations_s;
      charts.push({ id, chart: new Chart(texts.time.charts[id], traces, window, marks_s, actions) });
    }
    list.append(...charts.map(({ chart }) => chart.element));
    draw();
  }

  function resize(): void {
    if (charts.length === 0 || list.clientWidth === 0) return;
    const height = Math.max(Math.floor((list.clientHeight - about.offsetHeight) / charts.length), LEAST_HEIGHT_PX);
    for (const { chart } of charts) chart.resize(list.clientWidth, height);
  }

  function draw(): void {
    if (!robot) return;
    const columns = Math.max(Math.round((list.clientWidth - LEFT_PX - RIGHT_PX) * devicePixelRatio), 50);
    const curves = new Map<Group | SeriesKind, Curves>();
    const { segments } = robot;
    const { start_s, end_s } = window;
    const isRough = isTooMuch(segments, start_s, end_s);
    tellWhatIsRough(isRough);
    resize();
    if (!isRough) fetchWithin(segments, start_s, end_s);
    const drawn = (source: Group | SeriesKind): Curves => {
      const series = seriesOf(source);
      if (series) return seriesCurves(series, start_s, end_s, columns);
      const group = source as Group;
      if (isRough) return overviewOf(segments, group, leavesOf(group).probe.width, start_s, end_s, columns);
      return curvesOf(segments, leavesOf(group), start_s, end_s, columns);
    };
    for (const { id, chart } of charts) {
      const source = sourceOf[id];
      if (!curves.has(source)) curves.set(source, drawn(source));
      chart.show(curves.get(source)!);
    }
    point();
  }

  function tellWhatIsRough(isRough: boolean): void {
    const said = new Set<string>();
    for (const { id } of charts) {
      const source = sourceOf[id];
      const series = seriesOf(source);
      if (!series && isRough) said.add(texts.time.rough);
      if (series && series.step_s > 0) {
        said.add(texts.time.stepped(texts.time.series[source as SeriesKind], short(1000 * series.step_s)));
      }
    }
    about.hidden = said.size === 0;
    about.textContent = [...said].join(". ");
  }

  function point(): void {
    if (!robot || robot.segments.count === 0) return;
    const now_s = store.get("time_s");
    const t_s = hover_s ?? now_s;
    const index = robot.segments.at(t_s);
    for (const { id, chart } of charts) chart.point(now_s, valuesAt(sourceOf[id], index, t_s));
  }

  function valuesAt(source: Group | SeriesKind, index: number, t_s: number): ArrayLike<number> {
    const series = seriesOf(source);
    if (series) {
      const values = new Float32Array(series.width);
      series.put(t_s, values);
      return values;
    }
    const { probe } = leavesOf(source as Group);
    const values = new Float64Array(probe.width);
    const spot = probe.spot(index);
    if (spot) probe.put(spot, Math.min(t_s - spot.chunk.start_s[spot.i], spot.part.duration_s), values);
    else values.fill(NaN);
    return values;
  }

  const chooser = createChooser(build);
  list.append(empty, about);
  window.on(() => later(draw));
  store.on("time_s", point);
  store.on("fetched", () => {
    if (robot && isTooMuch(robot.segments, window.start_s, window.end_s)) point();
    else later(draw);
  });
  store.on("units", () => build(chooser.chosen));
  onTheme(() => build(chooser.chosen));
  new ResizeObserver(() => {
    resize();
    later(draw);
  }).observe(list);

  return {
    chooser: chooser.element,
    list,
    begin(marks) {
      robot = robotOf(store);
      leaves = new Map();
      hover_s = null;
      excesses_s = marks.filter(({ kind }) => kind === "motor").map(({ t_s }) => t_s);
      violations_s = marks.filter(({ kind }) => kind === "violation" || kind === "zone").map(({ t_s }) => t_s);
      chooser.begin(robot?.scene.axes ?? [], chartsOf(robot));
      build(chooser.chosen);
    },
  };
}

// Charts below the scrubber, and the selection of their contents.

import { element } from "../../core/dom";
import { shownRobot } from "../../core/display_state";
import type { Store } from "../../core/store";
import { onTheme } from "../../core/theme";
import type { Mark } from "../../run/marks";
import type { Robot } from "../../run/run";
import type { Series, SeriesKind } from "../../run/series";
import { texts } from "../../texts";
import type { TimeWindow } from "../time_window";
import { LEFT_PX, RIGHT_PX, Chart } from "./chart";
import { createChooser, type ChartSelection } from "./chooser";
import { createCurves, type Curves } from "./curves";
import { ExtremaTree } from "./extrema_tree";
import { fetchRange, needsOverview, overviewCurves } from "./overview";
import type { Group } from "./curve_sampler";
import { seriesCurves } from "./series_curves";
import { availableCharts, short, chartSource, createTraces, type ChartId } from "./traces";

const MIN_HEIGHT_PX = 100;

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
  let leaves = new Map<Group, ExtremaTree>();
  let hover_s: number | null = null;
  let frame = 0;

  const later = (what: () => void) => {
    cancelAnimationFrame(frame);
    frame = requestAnimationFrame(what);
  };
  const groupLeaves = (group: Group): ExtremaTree => {
    const known = leaves.get(group);
    if (known) return known;
    const made = new ExtremaTree(robot!.segments, group, () => made === leaves.get(group) && later(draw));
    leaves.set(group, made);
    return made;
  };

  /** Returns null for data that comes from laws. */
  const sourceSeries = (source: Group | SeriesKind): Series | null => robot?.series.get(source as SeriesKind) ?? null;

  function build(chosen: ChartSelection): void {
    for (const { chart } of charts) chart.destroy();
    charts = [];
    empty.hidden = !robot || chosen.charts.length > 0;
    if (!robot) return;
    const actions = {
      choose: (t_s: number) => store.set("time_s", Math.min(Math.max(t_s, 0), window.total_s)),
      hover: (t_s: number | null) => {
        hover_s = t_s;
        point();
      },
    };
    for (const id of chosen.charts) {
      const traces = createTraces(id, robot, { ...chosen, units: store.get("units") });
      if (traces.length === 0) continue;
      const marks_s = id === "effort" ? excesses_s : violations_s;
      charts.push({ id, chart: new Chart(texts.time.charts[id], traces, window, marks_s, actions) });
    }
    list.append(...charts.map(({ chart }) => chart.element));
    draw();
  }

  function resize(): void {
    if (charts.length === 0 || list.clientWidth === 0) return;
    const height = Math.max(Math.floor((list.clientHeight - about.offsetHeight) / charts.length), MIN_HEIGHT_PX);
    for (const { chart } of charts) chart.resize(list.clientWidth, height);
  }

  function draw(): void {
    if (!robot) return;
    const columns = Math.max(Math.round((list.clientWidth - LEFT_PX - RIGHT_PX) * devicePixelRatio), 50);
    const curves = new Map<Group | SeriesKind, Curves>();
    const { segments } = robot;
    const { start_s, end_s } = window;
    const isOverview = needsOverview(segments, start_s, end_s);
    showOverviewNote(isOverview);
    resize();
    if (!isOverview) fetchRange(segments, start_s, end_s);
    const drawn = (source: Group | SeriesKind): Curves => {
      const series = sourceSeries(source);
      if (series) return seriesCurves(series, start_s, end_s, columns);
      const group = source as Group;
      if (isOverview) return overviewCurves(segments, group, groupLeaves(group).probe.width, start_s, end_s, columns);
      return createCurves(segments, groupLeaves(group), start_s, end_s, columns);
    };
    for (const { id, chart } of charts) {
      const source = chartSource[id];
      if (!curves.has(source)) curves.set(source, drawn(source));
      chart.show(curves.get(source)!);
    }
    point();
  }

  function showOverviewNote(isOverview: boolean): void {
    const said = new Set<string>();
    for (const { id } of charts) {
      const source = chartSource[id];
      const series = sourceSeries(source);
      if (!series && isOverview) said.add(texts.time.rough);
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
    for (const { id, chart } of charts) chart.point(now_s, valuesAt(chartSource[id], index, t_s));
  }

  function valuesAt(source: Group | SeriesKind, index: number, t_s: number): ArrayLike<number> {
    const series = sourceSeries(source);
    if (series) {
      const values = new Float32Array(series.width);
      series.put(t_s, values);
      return values;
    }
    const { probe } = groupLeaves(source as Group);
    const values = new Float64Array(probe.width);
    const segmentRef = probe.segmentRef(index);
    if (segmentRef) probe.put(segmentRef, Math.min(t_s - segmentRef.chunk.start_s[segmentRef.i], segmentRef.part.duration_s), values);
    else values.fill(NaN);
    return values;
  }

  const chooser = createChooser(build);
  list.append(empty, about);
  window.on(() => later(draw));
  store.on("time_s", point);
  store.on("loadCount", () => {
    if (robot && needsOverview(robot.segments, window.start_s, window.end_s)) point();
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
      robot = shownRobot(store);
      leaves = new Map();
      hover_s = null;
      excesses_s = marks.filter(({ kind }) => kind === "motor").map(({ t_s }) => t_s);
      violations_s = marks.filter(({ kind }) => kind === "violation" || kind === "zone").map(({ t_s }) => t_s);
      chooser.begin(robot?.scene.axes ?? [], availableCharts(robot));
      build(chooser.chosen);
    },
  };
}

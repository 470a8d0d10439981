// Contents of each chart: its curves, their unit, and their limits.

import { axisColour, orange } from "../../core/colours";
import type { Units } from "../../core/store";
import { themeColour } from "../../core/theme";
import { length, lengthUnit } from "../../core/units";
import { RAD_PER_DEG } from "../../run/chain";
import type { Robot } from "../../run/run";
import type { Axis, Scene } from "../../run/scene";
import type { SeriesKind } from "../../run/series";
import { texts } from "../../texts";
import { symmetricLimits } from "./limit_lines";
import { PATH, type Group } from "./curve_sampler";
import { seriesTraces, type SeriesChartId } from "./series_traces";
import type { Choice, ScaleId, Trace } from "./trace";

const words = texts.time;

const lawCharts = ["speed", "acceleration", "axis_position", "axis_speed", "axis_acceleration"] as const;
const seriesCharts: readonly SeriesChartId[] = ["effort", "power", "following", "contour"];
type LawChartId = (typeof lawCharts)[number];
export type ChartId = LawChartId | SeriesChartId;
export const chartIds: readonly ChartId[] = [...lawCharts, ...seriesCharts];

/** Source of a chart's values: laws of segments, or a series. */
export const chartSource: Record<ChartId, Group | SeriesKind> = {
  speed: "path",
  acceleration: "path",
  axis_position: "position",
  axis_speed: "speed",
  axis_acceleration: "acceleration",
  effort: "efforts",
  power: "efforts",
  following: "following",
  contour: "following",
};

const isSeriesChart = (id: ChartId): id is SeriesChartId => seriesCharts.some((each) => each === id);

/** Returns the available charts of a robot. */
export const availableCharts = (robot: Robot | undefined): ChartId[] =>
  chartIds.filter((id) => !isSeriesChart(id) || robot?.series.has(chartSource[id] as SeriesKind));

/** Returns the unit of a chart's values on a scale. */
function unitOf(id: LawChartId, scale: ScaleId, units: Units): string {
  if (scale === "percent") return "%";
  const way = scale === "deg" ? "°" : lengthUnit(units);
  if (id === "axis_position") return way;
  return id.endsWith("speed") ? `${way}/min` : `${way}/s²`;
}

export function createTraces(id: ChartId, { scene, series }: Robot, choice: Choice): Trace[] {
  if (isSeriesChart(id)) {
    const from = series.get(chartSource[id] as SeriesKind);
    return from ? seriesTraces(id, from, scene, choice) : [];
  }
  if (id === "speed") return speedTraces(scene, choice.units);
  if (id === "acceleration") return [accelerationTrace(scene, choice.units)];
  return scene.axes
    .map((axis, joint) => axisTrace(id, axis, joint, choice))
    .filter((trace) => choice.axes.has(trace.channel));
}

function speedTraces(scene: Scene, units: Units): Trace[] {
  const factor = length(60, units);
  const unit = unitOf("speed", "mm", units);
  const common = { scale: "mm", unit, factor, offset: 0, fromZero: true } as const;
  const limits = [
    { max: scene.max_feed_mm_s, label: words.maxFeed },
    { max: scene.max_rapid_mm_s, label: words.maxRapid },
  ].flatMap(({ max, label }) => (max === null ? [] : [{ value: max * factor, label, colour: orange }]));
  return [
    { ...common, name: words.tipSpeed, channel: PATH.speed, colour: themeColour("--accent"), dashed: false, limits },
    { ...common, name: words.feedAsked, channel: PATH.feed, colour: orange, dashed: true, limits: [] },
  ];
}

function accelerationTrace(scene: Scene, units: Units): Trace {
  const max = scene.max_acceleration_mm_s2;
  return {
    name: words.pathAcceleration,
    channel: PATH.acceleration,
    colour: themeColour("--accent"),
    dashed: false,
    scale: "mm",
    unit: unitOf("acceleration", "mm", units),
    factor: length(1, units),
    offset: 0,
    fromZero: true,
    limits: max === null ? [] : symmetricLimits(length(max, units), words.limit, orange),
  };
}

function axisTrace(id: LawChartId, axis: Axis, joint: number, { units, percent }: Choice): Trace {
  const colour = axisColour(joint);
  const label = words.limitOf(axis.letter);
  const max = id === "axis_speed" ? axis.max_speed : axis.max_acceleration;
  const asPercent = id !== "axis_position" && percent && max !== null;
  const scale: ScaleId = asPercent ? "percent" : axis.rotary ? "deg" : "mm";
  const perSecond = id === "axis_speed" && !asPercent ? 60 : 1;
  const displayed = (value: number) => (axis.rotary ? value : length(value, units)) * perSecond;
  const scaled = asPercent ? 100 / max : displayed(1);
  const common = {
    name: axis.letter,
    channel: joint,
    colour,
    dashed: false,
    scale,
    unit: unitOf(id, scale, units),
    fromZero: id !== "axis_position",
  };
  const factor = scaled * (axis.rotary ? 1 / RAD_PER_DEG : 1);
  if (id === "axis_position") {
    const ends = [axis.min, axis.max].filter((end) => end !== null);
    const limits = ends.map((end) => ({ value: displayed(end), label, colour }));
    return { ...common, factor, offset: displayed(axis.zero), limits };
  }
  if (asPercent) return { ...common, factor, offset: 0, limits: symmetricLimits(100, words.limit, orange) };
  return { ...common, factor, offset: 0, limits: max === null ? [] : symmetricLimits(displayed(max), label, colour) };
}

/** "1,234", "0.0567": four digits or so. */
export function short(value: number): string {
  const size = Math.abs(value);
  if (size >= 1000) return value.toFixed(0);
  if (size >= 100) return value.toFixed(1);
  return size >= 1 || size === 0 ? value.toFixed(2) : value.toPrecision(3);
}

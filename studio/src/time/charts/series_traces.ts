// Traces in charts of forces, power and following errors.

import { axisColour, orange } from "../../core/colours";
import type { Units } from "../../core/store";
import { themeColour } from "../../core/theme";
import { length, lengthUnit } from "../../core/units";
import type { Axis, Scene } from "../../run/scene";
import type { Series } from "../../run/series";
import { texts } from "../../texts";
import { symmetricLimits } from "./limit_lines";
import type { Choice, Trace } from "./trace";

const words = texts.time;

export type SeriesChartId = "effort" | "power" | "following" | "contour";

const common = { dashed: false, factor: 1, offset: 0, fromZero: true, limits: [] };

export function seriesTraces(id: SeriesChartId, series: Series, { axes }: Scene, choice: Choice): Trace[] {
  if (id === "power") return [powerTrace(series)];
  if (id === "contour") return [contourTrace(series, choice.units)];
  return axes.flatMap((axis, joint) => {
    if (!choice.axes.has(joint)) return [];
    return id === "effort" ? effortTraces(series, axis, joint, choice.percent) : [errorTrace(series, axis, joint, choice)];
  });
}

function powerTrace(series: Series): Trace {
  const colour = themeColour("--accent");
  return { ...common, name: words.allMotors, channel: series.channel("power"), colour, scale: "power", unit: "W" };
}

function contourTrace(series: Series, units: Units): Trace {
  const own = { ...common, name: words.ofTip, channel: series.channel("contour"), colour: themeColour("--accent") };
  return { ...own, scale: "mm", unit: lengthUnit(units), factor: length(1, units) };
}

function errorTrace(series: Series, axis: Axis, joint: number, { units }: Choice): Trace {
  const own = { ...common, name: axis.letter, channel: series.channel("error", joint), colour: axisColour(joint) };
  if (axis.rotary) return { ...own, scale: "deg", unit: "°" };
  return { ...own, scale: "mm", unit: lengthUnit(units), factor: length(1, units) };
}

/** If the motor is weaker at some speeds, its limit is drawn over time, in both directions. */
function effortTraces(series: Series, axis: Axis, joint: number, percent: boolean): Trace[] {
  const { letter, motor_peak: peak, motor_fades: fades } = axis;
  const colour = axisColour(joint);
  const own = { ...common, name: letter, channel: series.channel("effort", joint), colour };
  if (percent && (fades || peak !== null)) {
    const from = fades ? { channel: series.channel("share", joint), factor: 100 } : { factor: 100 / peak! };
    return [{ ...own, ...from, scale: "percent", unit: "%", limits: symmetricLimits(100, words.limit, orange) }];
  }
  const scale = axis.rotary ? ("torque" as const) : ("force" as const);
  const effort = { ...own, scale, unit: axis.rotary ? "Nm" : "N" };
  const label = words.limitOf(letter);
  if (!fades) return [{ ...effort, limits: peak === null ? [] : symmetricLimits(peak, label, colour) }];
  const limit = { ...effort, name: label, channel: series.channel("motor_peak", joint), dashed: true, isLimit: true };
  return [effort, limit, { ...limit, factor: -1 }];
}

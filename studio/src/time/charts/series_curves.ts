// Curves of a series over a stretch of time: its instants if they are few, else lowest and highest values for
// each column of pixels.

import type { Series } from "../../run/series";
import { push, type Curves } from "./curves";

/** `columns`: width of the stretch in pixels. */
export function seriesCurves(series: Series, from_s: number, to_s: number, columns: number): Curves {
  const curves: Curves = { t_s: [], values: series.channels.map(() => []), areColumns: false };
  if (series.count === 0 || !(to_s > from_s)) return curves;
  const [first, last] = [series.indexAt(from_s), series.indexAt(to_s)];
  if (series.step_s === 0 && last - first < 2 * columns) addInstants(series, first, last, from_s, to_s, curves);
  else if (series.step_s > 0 && last - first < columns) addSteps(series, first, last, from_s, to_s, curves);
  else addColumns(series, from_s, to_s, columns, curves);
  return curves;
}

function addInstants(series: Series, first: number, last: number, from_s: number, to_s: number, curves: Curves): void {
  const point = new Float32Array(series.width);
  const put = (t_s: number) => {
    series.put(t_s, point);
    push(curves, t_s, point);
  };
  put(from_s);
  for (let i = first + 1; i <= last; ++i) push(curves, series.time_s(i), series.row(i));
  put(to_s);
}

/** Adds steps; each has the same value at its end as at its start. */
function addSteps(series: Series, first: number, last: number, from_s: number, to_s: number, curves: Curves): void {
  curves.areColumns = true;
  for (let step = Math.max(first, 0); step <= Math.min(last, series.count - 1); ++step) {
    const [low, high] = columnExtremes(series, step, step);
    for (const t_s of [Math.max(series.time_s(step), from_s), Math.min(series.time_s(step + 1), to_s)]) {
      push(curves, t_s, low);
      push(curves, t_s, high);
    }
  }
}

function addColumns(series: Series, from_s: number, to_s: number, columns: number, curves: Curves): void {
  curves.areColumns = true;
  const step_s = (to_s - from_s) / columns;
  const edge = new Float32Array(series.width);
  for (let column = 0; column < columns; ++column) {
    const begin_s = from_s + column * step_s;
    const end_s = begin_s + step_s;
    const first = series.indexAt(begin_s) + (series.step_s > 0 ? 0 : 1);
    const [low, high] = columnExtremes(series, first, series.indexAt(end_s));
    // Between two instants, both edges have interpolated values.
    for (const t_s of series.step_s > 0 ? [] : [begin_s, end_s]) {
      series.put(t_s, edge);
      for (let j = 0; j < edge.length; ++j) {
        if (edge[j] < low[j] || Number.isNaN(low[j])) low[j] = edge[j];
        if (edge[j] > high[j] || Number.isNaN(high[j])) high[j] = edge[j];
      }
    }
    push(curves, begin_s + step_s / 4, low);
    push(curves, begin_s + step_s / 4, high);
  }
}

/** Returns the extremes from one instant or step to another; NaN if without values. */
function columnExtremes(series: Series, first: number, last: number): [low: Float32Array, high: Float32Array] {
  const low = new Float32Array(series.width).fill(Infinity);
  const high = new Float32Array(series.width).fill(-Infinity);
  const end = Math.min(last, series.count - 1);
  for (let index = Math.max(first, 0); index <= end; ++index) series.expand(index, low, high);
  for (let j = 0; j < series.width; ++j) if (low[j] > high[j]) low[j] = high[j] = NaN;
  return [low, high];
}

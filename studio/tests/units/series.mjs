// Curves over time that the engine sends by instants or by steps: forces and following errors.

import assert from "node:assert/strict";
import { near, runOf, scene } from "./made.mjs";

export const modules = ["run/run", "run/marks", "run/series", "time/charts/series_curves", "time/charts/traces", "core/units"];

const [X, C] = [0, 1];
const power = { of: "power" };
const channels = [power, { of: "effort", axis: X }, { of: "effort", axis: C }];

function message(is, header, columns) {
  return { is, header: { robot: 0, channels, step_s: 0, ...header }, columns: new Map(Object.entries(columns)) };
}

/** Instants: [time, power, effort of X, effort of C]. */
function instants(rows, is = "efforts") {
  const t_s = Float64Array.from(rows, ([time]) => time);
  return message(is, {}, { t_s, values: Float32Array.from(rows.flatMap((row) => row.slice(1))) });
}

/** Returns steps of a second: [lowest, highest] of X; no other values. */
function steps(rows) {
  const all = (side) => Float32Array.from(rows.flatMap((row) => [NaN, row[side], NaN]));
  return message("efforts", { step_s: 1 }, { low: all(0), high: all(1) });
}

function at(series, t_s) {
  const values = new Float32Array(series.width);
  series.put(t_s, values);
  return [...values];
}

/** Of X in each column of pixels: the lowest and the highest. */
function columnsOf(page, series, from_s, to_s, count) {
  const { values, areColumns } = page.seriesCurves(series, from_s, to_s, count);
  assert.equal(areColumns, true);
  return values[1];
}

const axesOf = (motors) => scene().axes.map((axis, i) => ({ ...axis, motor_peak: null, motor_fades: false, ...motors[i] }));
const choice = { units: "mm", axes: new Set([X, C]), percent: false };

export default {
  "values are straight between instants, jump where there are two, and end with them": ({ Series }) => {
    const series = new Series(instants([[1, 10, 0, 5], [2, 20, 4, 5], [2, 20, 8, NaN], [4, 0, 0, 5]]));
    assert.deepEqual(at(series, 1.5), [15, 2, 5]);
    assert.deepEqual(at(series, 2).slice(0, 2), [20, 8]);
    assert.deepEqual(at(series, 3).slice(0, 2), [10, 4]);
    assert.ok(Number.isNaN(at(series, 3)[2]), "nothing where one side has nothing");
    assert.deepEqual([at(series, 1)[1], at(series, 4)[1]], [0, 0]);
    for (const t_s of [0.9, 4.1]) assert.ok(at(series, t_s).every(Number.isNaN));
    assert.deepEqual([series.channel("effort", C), series.channel("power"), series.channel("share", X)], [2, 0, -1]);
  },

  "few instants are drawn as they are, cut at the ends of the window": (page) => {
    const series = new page.Series(instants([[0, 0, 0, 0], [2, 0, 4, 0], [2, 0, 8, 0], [4, 0, 0, 0]]));
    const { t_s, values, areColumns } = page.seriesCurves(series, 1, 3, 100);
    assert.equal(areColumns, false);
    assert.deepEqual(t_s, [1, 2, 2, 3]);
    assert.deepEqual(values[1], [2, 4, 8, 4]);
  },

  "of many instants no peak is lost, and columns between two instants have what is between them": (page) => {
    const saw = Array.from({ length: 1001 }, (_, i) => [i / 100, 0, i % 2, 0]);
    saw[333][2] = 7;
    const series = new page.Series(instants([...saw, [20, 0, 10, 0]]));
    const drawn = columnsOf(page, series, 0, 20, 20);
    assert.deepEqual(drawn.slice(0, 8), [0, 1, 0, 1, 0, 1, 0, 7]);
    near(drawn[24], 2, 1e-6, "lowest from 12 to 13 s");
    near(drawn[25], 3, 1e-6, "highest there");
  },

  "steps are drawn as areas, or together in a column": (page) => {
    const series = new page.Series(steps([[0, 1], [-5, 2], [NaN, NaN], [3, 4]]));
    const drawn = page.seriesCurves(series, 0.5, 1.5, 100);
    assert.deepEqual([drawn.areColumns, drawn.t_s], [true, [0.5, 0.5, 1, 1, 1, 1, 1.5, 1.5]]);
    assert.deepEqual(drawn.values[1], [0, 1, 0, 1, -5, 2, -5, 2]);
    assert.deepEqual(columnsOf(page, series, 0, 4, 2), [-5, 2, 3, 4]);
    assert.deepEqual([0.5, 1.5, 3.5].map((t_s) => at(series, t_s)[1]), [1, -5, 4], "what is farthest from 0");
    for (const t_s of [-0.1, 2.5, 4.5]) assert.ok(Number.isNaN(at(series, t_s)[1]));
  },

  "there are charts of forces and errors where the machine tells of them": (page) => {
    const run = runOf(page, [{ line: 1, duration_s: 4 }]);
    const [robot] = run.robots;
    assert.ok(!page.availableCharts(robot).includes("effort"));
    assert.deepEqual(page.createTraces("effort", robot, choice), []);
    run.addMessage(instants([[0, 0, 0, 0]]));
    const charts = page.availableCharts(robot);
    assert.deepEqual(["effort", "power", "following", "contour"].map((id) => charts.includes(id)), [true, true, false, false]);
  },

  "forces and torques have scales of their own, and the motor's peak as limits": (page) => {
    const run = runOf(page, [{ line: 1, duration_s: 4 }], { more: { axes: axesOf([{ motor_peak: 200 }, {}]) } });
    run.addMessage(instants([[0, 0, 0, 0]]));
    const traces = page.createTraces("effort", run.robots[0], choice);
    assert.deepEqual(traces.map(({ unit, channel }) => [unit, channel]), [["N", 1], ["Nm", 2]]);
    assert.deepEqual(traces.map(({ limits }) => limits.map(({ value }) => value)), [[200, -200], []]);
    const [share, torque] = page.createTraces("effort", run.robots[0], { ...choice, percent: true });
    assert.deepEqual([share.unit, share.factor, torque.unit], ["%", 0.5, "Nm"]);
  },

  "a motor that has less at some speeds has its limit over time": (page) => {
    const run = runOf(page, [{ line: 1, duration_s: 4 }], { more: { axes: axesOf([{ motor_peak: 200, motor_fades: true }, {}]) } });
    const faded = [...channels, { of: "motor_peak", axis: X }, { of: "share", axis: X }];
    const values = Float32Array.from([0, 50, 0, 100, 0.5]);
    run.addMessage(message("efforts", { channels: faded }, { t_s: Float64Array.of(0), values }));
    const own = page.createTraces("effort", run.robots[0], { ...choice, axes: new Set([X]) });
    assert.deepEqual(own.map(({ channel, factor, isLimit }) => [channel, factor, isLimit ?? false]), [[1, 1, false], [3, 1, true], [3, -1, true]]);
    const [share] = page.createTraces("effort", run.robots[0], { ...choice, percent: true });
    assert.deepEqual([share.channel, share.factor], [4, 100]);
  },

  "errors are in mm or inch, and degrees of rotary axes": (page) => {
    const run = runOf(page, [{ line: 1, duration_s: 4 }]);
    const errors = [{ of: "contour" }, { of: "error", axis: X }, { of: "error", axis: C }];
    run.addMessage(message("following", { channels: errors }, { t_s: Float64Array.of(0), values: new Float32Array(3) }));
    const inch = { ...choice, units: "inch" };
    assert.deepEqual(page.createTraces("following", run.robots[0], inch).map(({ unit }) => unit), ["in", "°"]);
    near(page.createTraces("following", run.robots[0], inch)[0].factor, 1 / 25.4);
  },

  "moves that ask for more than a motor has are marks, the whole run is none": (page) => {
    const excess = (kind, t_s, line) => ({ kind, t_s, line, file: line && "a.nc", axis: "X", message: `${kind} of X` });
    const efforts = { excesses: [excess("peak", 1.5, 2), excess("continuous", 0, null)] };
    const marks = page.runMarks(runOf(page, [{ line: 2, duration_s: 4 }], { report: { efforts } }), 0);
    assert.deepEqual(marks.map(({ kind, t_s, line, text }) => [kind, t_s, line, text]), [["motor", 1.5, 2, "peak of X"]]);
  },

  "figures have three digits, and energies their unit": ({ valueText, energyText }) => {
    assert.deepEqual([0, 0.012345, 12.345, -812.4, 12345].map(valueText), ["0", "0.0123", "12.3", "-812", "12,345"]);
    assert.deepEqual([48.12, 1234].map(energyText), ["48.1 J", "1.23 kJ"]);
  },
};

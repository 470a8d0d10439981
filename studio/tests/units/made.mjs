// Runs made by hand: laws, segments and messages as the engine writes them (docs/studio.md).

import assert from "node:assert/strict";

export function near(actual, expected, tolerance = 1e-9, what = "") {
  assert.ok(Math.abs(actual - expected) <= tolerance, `${what} ${actual}, not ${expected}`);
}

/** The slope of a function, by what it is on both sides. */
export const slope = (of, at, step = 1e-5) => (of(at + step) - of(at - step)) / (2 * step);

/**
 * Returns the numbers of a law from its start speed and parts [duration, acceleration at its start, jerk].
 */
export function lawOf(speed, pieces) {
  let [s, v] = [0, speed];
  const numbers = pieces.flatMap(([t, a, jerk]) => {
    const section = [t, s, v, a, jerk];
    s += t * (v + t * (a / 2 + (t * jerk) / 6));
    v += t * (a + (t * jerk) / 2);
    return section;
  });
  return [s, pieces.reduce((sum, [t]) => sum + t, 0), v, pieces.length, ...numbers];
}

/** Returns a law of constant speed between two standstills. */
export const steady = (length, duration_s) => lawOf(length / duration_s, [[duration_s, 0, 0]]);

/** A straight segment's record: two joints go in proportion to the lead. */
export const straight = (start, end, duration_s) => [
  ...start,
  ...end,
  ...steady(Math.hypot(...start.map((from, i) => end[i] - from)) || 1, duration_s),
  0,
];

const plain = { file: 0, kind: 1, limit: 0, axis: -1, feed_per_min: 600, length_mm: 1, processOn: false };

/**
 * Returns a message of segments of two joints. Each of `moves` has a `line` and a `duration_s`; the remainder
 * is as in `plain`. The first is number `first`, and begins at `start_s`.
 */
export function segmentsMessage(moves, first = 0, start_s = 0) {
  const all = moves.map((move) => ({ ...plain, ...move }));
  const columns = new Map();
  const put = (name, type, of) => columns.set(name, type.from(all, of));
  let t_s = start_s;
  put("start_s", Float64Array, ({ duration_s }) => (t_s += duration_s) - duration_s);
  for (const name of ["duration_s", "length_mm", "feed_per_min"]) put(name, Float64Array, (move) => move[name]);
  for (const name of ["line", "file"]) put(name, Uint32Array, (move) => move[name]);
  put("flags", Uint32Array, ({ kind, limit, axis, processOn }) => {
    return 1 | (processOn ? 4 : 0) | (kind << 8) | (limit << 12) | ((axis + 1) << 16);
  });
  const records = all.map(({ duration_s, from = [0, 0], to = [1, 0] }) => straight(from, to, duration_s));
  let at = 0;
  columns.set("record", Uint32Array.from(records, (record) => (at += record.length) - record.length));
  columns.set("values", Float64Array.from(records.flat()));
  for (const name of ["deviation_mm", "vertex_mm", "vertex_s"]) columns.set(name, new Float32Array(all.length));
  for (const name of ["tip", "vertex_segment"]) columns.set(name, new Uint32Array(all.length));
  return { is: "segments", header: { robot: 0, first }, columns };
}

/**
 * Returns the same with only the path and the lines (docs/studio-server.md): a vertex at the end of each
 * segment, x its number; those that `rests` have none.
 */
export function leanMessage(moves, first = 0, start_s = 0) {
  const { columns } = segmentsMessage(moves, first, start_s);
  const [starts_s, durations_s] = [columns.get("start_s"), columns.get("duration_s")];
  const [line, file] = [columns.get("line"), columns.get("file")];
  const codeOf = (length_mm, duration_s) => (length_mm > 0 && duration_s > 0 ? Math.round(8 * Math.log2(length_mm / duration_s)) + 17 : 0);
  const lines = [];
  moves.forEach((_, i) => {
    const [row, of, from, step] = lines.slice(-4);
    const isFirst = i === row + 1 && of === file[i] && lines.length > 0;
    if (isFirst) lines[lines.length - 1] = line[i] - line[i - 1];
    else if (of !== file[i] || line[i] !== from + step * (i - row)) lines.push(i, file[i], line[i], 0);
  });
  const drawn = moves.flatMap(({ isStationary }, i) => (isStationary ? [] : [i]));
  const vertices = new Map([
    ["vertex_mm", Float32Array.from(drawn.flatMap((i) => [first + i + 1, 0, 0]))],
    ["vertex_s", Float32Array.from(drawn, (i) => starts_s[i] + durations_s[i] - starts_s[0])],
    [
      "vertex_segment",
      Uint32Array.from(drawn, (i) => {
        const flags = columns.get("flags")[i];
        const look = ((flags >>> 8) & 0xff) | (((flags >>> 2) & 1) << 8) | (codeOf(columns.get("length_mm")[i], durations_s[i]) << 9);
        return (i | (look << 16)) >>> 0;
      }),
    ],
    ["lines", Uint32Array.from(lines)],
  ]);
  const last = moves.length - 1;
  const header = { robot: 0, first, lean: true, count: moves.length, start_s: starts_s[0], end_s: starts_s[last] + durations_s[last] };
  return { is: "segments", header, columns: vertices };
}

/**
 * Returns a long run: `parts` of moves as of segmentsMessage, of which the first `whole` are permanently
 * loaded; `fetched(number)` is called for each request, and may throw.
 */
export function longRunOf({ Run }, parts, { whole = 1, files = ["a.nc", "b.nc"], fetched = () => {} } = {}) {
  const wholes = [];
  const run = new Run(new Map(), async (number) => {
    fetched(number);
    return wholes[number];
  });
  run.addMessage({ is: "scene", header: { robot: 0, name: "one", scene: scene(), files }, columns: new Map() });
  let [first, start_s] = [0, 0];
  parts.forEach((moves, i) => {
    const [all, lean] = [segmentsMessage(moves, first, start_s), leanMessage(moves, first, start_s)];
    all.columns.set("vertex_mm", lean.columns.get("vertex_mm"));
    const at_s = start_s;
    all.columns.set("vertex_s", lean.columns.get("vertex_s").map((since_s) => at_s + since_s));
    all.columns.set("vertex_segment", lean.columns.get("vertex_segment").map((packed) => packed & 0xffff));
    wholes.push(all);
    run.addMessage(i < whole ? all : lean);
    first += moves.length;
    start_s += moves.reduce((sum, { duration_s }) => sum + duration_s, 0);
  });
  run.addMessage({ is: "report", header: { report: { cycle_time_s: start_s, warnings: [] }, text: "" }, columns: new Map() });
  return run;
}

const identity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
export const moved = (x, y, z) => [...identity.slice(0, 12), x, y, z, 1];

const axis = (letter, rotary) => ({
  ...{ letter, rotary, min: null, max: null, max_speed: null, max_acceleration: null, max_jerk: null },
  ...{ home: 0, zero: 0, carries: "tool" },
});

/** Returns a scene: X moves along the world's Z by its frame, C turns after it, the tool is 10 mm out. */
export const scene = (more = {}) => ({
  machine: "made",
  controller: "none",
  base: identity,
  axes: [axis("X", false), axis("C", true)],
  position_joints: [0, -1, -1],
  tool_side: {
    base: moved(1, 2, 3),
    links: [
      { joint: 0, rotary: false, before: identity, after: identity },
      { joint: 1, rotary: true, before: identity, after: identity },
    ],
    end: moved(10, 0, 0),
  },
  work_side: { base: identity, links: [], end: identity },
  axis_space: null,
  max_feed_mm_s: null,
  max_rapid_mm_s: null,
  max_acceleration_mm_s2: null,
  process: null,
  zones: [],
  tcps_mm: [[0, 0, 0]],
  ...more,
});

/** A run of one robot: `moves` as of segmentsMessage, `files` its sources by name, `report` what it reports. */
export function runOf({ Run }, moves, { files = { "a.nc": "" }, report = {}, more = {} } = {}) {
  const run = new Run(new Map(Object.entries(files)));
  const header = { robot: 0, name: "one", scene: scene(more), files: Object.keys(files) };
  run.addMessage({ is: "scene", header, columns: new Map() });
  run.addMessage(segmentsMessage(moves));
  const cycle_time_s = moves.reduce((sum, { duration_s }) => sum + duration_s, 0);
  run.addMessage({ is: "report", header: { report: { cycle_time_s, warnings: [], ...report }, text: "" }, columns: new Map() });
  return run;
}

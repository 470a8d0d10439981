// Contents of charts and the view: curves that miss no peak, vertices of a path, positions on it, colours and
// grids.

import assert from "node:assert/strict";
import { lawOf, near, segmentsMessage } from "./made.mjs";

export const modules = [
  ...["run/segments", "time/charts/curve_sampler", "time/charts/extrema_tree", "time/charts/curves", "time/charts/traces"],
  ...["view/path/path_data", "view/path/path_colours", "view/picking", "view/marks/grid"],
];

const move = (line, duration_s, more = {}) => ({ line, duration_s, ...more });

/** Many short moves to and fro, one of them very fast. */
function shortMoves({ Segments }, count = 4000, fast = 1234) {
  const segments = new Segments(2, [0, 1]);
  segments.add(segmentsMessage(Array.from({ length: count }, (_, i) => move(i + 1, i === fast ? 0.001 : 0.01))));
  return segments;
}

/** Returns a path of three segments with two parts each; the second is rapid. */
function way(page) {
  const segments = new page.Segments(2, [0, 1]);
  const message = segmentsMessage([move(1, 2), move(2, 2, { kind: 0 }), move(3, 2)]);
  message.columns.set("vertex_mm", Float32Array.from([0, 0, 0, 1, 0, 0, 2, 0, 0, 2, 5, 0, 2, 9, 0, 3, 9, 0, 4, 9, 0]));
  message.columns.set("vertex_s", Float32Array.from([0, 1, 2, 3, 4, 5, 6]));
  message.columns.set("vertex_segment", Uint32Array.from([0, 0, 0, 1, 1, 2, 2]));
  segments.add(message);
  return new page.PathData(segments);
}

export default {
  "a curve of few segments is exact": (page) => {
    const segments = shortMoves(page, 3, -1);
    const leaves = new page.ExtremaTree(segments, "position", () => {});
    const { t_s, values, areColumns } = page.createCurves(segments, leaves, 0, 0.03, 300);
    assert.equal(areColumns, false);
    assert.deepEqual([t_s[0], t_s.at(-1)], [0, 0.03]);
    const inside = t_s.map((_, i) => i).filter((i) => i > 0 && Math.abs(t_s[i] - 0.01) > 1e-6 && Math.abs(t_s[i] - 0.02) > 1e-6);
    assert.ok(inside.length > 290);
    for (const i of inside) near(values[0][i], segments.joints_at(t_s[i]).position[0]);
    const jump = values[0].filter((_, i) => Math.abs(t_s[i] - 0.01) < 1e-9).map(Math.round);
    assert.deepEqual([jump[0], jump.at(-1)], [1, 0], "both sides of it");
  },

  "a curve of many segments misses no peak": async (page) => {
    const segments = shortMoves(page);
    let leaves = null;
    await new Promise((done) => {
      leaves = new page.ExtremaTree(segments, "path", done);
      if (leaves.ready) done();
    });
    const { values, areColumns } = page.createCurves(segments, leaves, 0, segments.end_s, 100);
    assert.equal(areColumns, true);
    near(Math.max(...values[page.PATH.speed]), 1000, 1e-3);
    near(Math.min(...values[page.PATH.speed].filter(Number.isFinite)), 100, 1e-3);
    near(Math.max(...values[page.PATH.feed]), 10, 1e-6);
  },

  "a probe widens to what a law comes to within a segment": ({ Segments, CurveSampler }) => {
    const message = segmentsMessage([move(1, 2, { length_mm: 10 })]);
    // Up to 5 and down to 0 within 2 s; the joint moves 10 mm for the 5 of the leading law.
    message.columns.set("values", Float64Array.from([0, 0, 10, 0, ...lawOf(0, [[1, 5, 0], [1, -5, 0]]), 0]));
    const segments = new Segments(2, [0, 1]);
    segments.add(message);
    const widened = (group) => {
      const probe = new CurveSampler(segments, group);
      const [low, high] = [new Float32Array(probe.width).fill(Infinity), new Float32Array(probe.width).fill(-Infinity)];
      probe.expand(probe.segmentRef(0), low, high, 0);
      return [low[0], high[0]];
    };
    assert.deepEqual(widened("path"), [0, 10]);
    assert.deepEqual(widened("position"), [0, 10]);
    assert.deepEqual(widened("speed"), [0, 10]);
    assert.deepEqual(widened("acceleration"), [-10, 10]);
  },

  "numbers of charts have about four digits": ({ short }) => {
    assert.deepEqual([0, 1234.4, 123.46, -12.346, 0.05678].map(short), ["0.00", "1234", "123.5", "-12.35", "0.0568"]);
  },

  "vertices of a way know their segments, and segments their vertices": (page) => {
    const data = way(page);
    assert.equal(data.count, 7);
    assert.deepEqual([1, 2, 3, 5, 6].map((vertex) => data.vertexSegment(vertex)), [0, 0, 1, 2, 2]);
    assert.deepEqual([data.vertexRange(0, 1), data.vertexRange(1, 2), data.vertexRange(1, 3)], [[0, 3], [3, 5], [3, 7]]);
    assert.deepEqual([-1, 0, 0.5, 5.5, 6, 9].map((t_s) => data.at(t_s)), [0, 1, 1, 6, 7, 7]);
    assert.deepEqual([data.isRapid(2), data.isRapid(3)], [false, true]);
    assert.deepEqual(data.bounds.max.toArray(), [4, 9, 0]);
    assert.deepEqual(data.texels(0, 7).slice(4 * 3, 4 * 4), Float32Array.from([2, 5, 0, 3]));
  },

  "a hit is as far along its piece as its time says": (page) => {
    const data = way(page);
    const { a, b, share } = page.hitSegment(data, { robot: 0, vertex: 3, t_s: 2.25 });
    assert.deepEqual([a.toArray(), b.toArray(), share], [[2, 0, 0], [2, 5, 0], 0.25]);
    const place = a.clone().lerp(b, 0.4);
    near(page.segmentShare(a, b, place), 0.4, 1e-12);
    assert.equal(page.segmentShare(a, a, place), 0);
    assert.equal(page.segmentShare(a, b, b.clone().multiplyScalar(9)), 1);
    near(page.lastDoneVertex(data, 2.9, place), 2.4, 1e-9);
    assert.equal(page.lastDoneVertex(data, 99, place), Infinity);
  },

  "colours of a way: classes that occur, and scales of what there is": (page) => {
    const data = way(page);
    assert.deepEqual(page.legendKey("kind", [data.segments]).classes, ["rapid", "linear"]);
    assert.deepEqual(page.legendKey("time", [data.segments]).scale, { low: 0, high: 6 });
    assert.deepEqual(page.legendKey("feed", [data.segments]).scale, { low: 600, high: 600 });
    assert.deepEqual(page.legendKey("feed", []).scale, { low: 0, high: 0 });
    const texels = page.colourTexels(data, page.legendKey("kind", [data.segments]), 0, 7);
    assert.deepEqual([texels[4 * 2 + 3], texels[4 * 3 + 3]], [0, page.RAPID_MARK]);
    assert.notDeepEqual([...texels.slice(8, 11)], [...texels.slice(12, 15)]);
  },

  "a grid's step is 1, 2 or 5 times a power of ten": ({ roundUp }) => {
    assert.deepEqual([0.7, 1, 1.1, 3, 5.1, 99, 100].map(roundUp), [1, 1, 2, 5, 10, 100, 100]);
  },
};

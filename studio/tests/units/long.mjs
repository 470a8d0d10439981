// Runs that are too long for the page: what is here of them, what is fetched, and what is kept of that.

import assert from "node:assert/strict";
import { leanMessage, longRunOf, near, runOf } from "./made.mjs";

export const modules = [
  ...["run/run", "run/segments", "run/run_section", "run/chunk_cache", "run/blocks", "core/store", "core/navigation", "core/display_state", "core/chunk_loading"],
  ...["time/steps", "time/process", "time/charts/overview", "time/charts/curve_sampler", "code/block_summary"],
  ...["view/path/path_data", "view/path/path_colours", "view/path/draw_plan", "view/selected_ranges"],
];

const move = (line, duration_s, more = {}) => ({ line, duration_s, from: [line, 0], to: [line + 1, 0], ...more });
const lines = (first, count, more) => Array.from({ length: count }, (_, i) => move(first + i, 1, more));
/** Line 1 to 4, 5 to 8, 9 to 12, 13 to 16: a second each. */
const PARTS = [1, 5, 9, 13].map((first) => lines(first, 4));

const soon = () => new Promise((done) => setTimeout(done));

function displayed(page, run) {
  const store = new page.Store(page.initialState());
  page.loadVisiblePart(store);
  if (run.laws) run.laws.onLoaded = () => store.set("loadCount", store.get("loadCount") + 1);
  store.set("run", run);
  return store;
}

export default {
  "a lean message says of each vertex its segment, its move, its process and its speed": ({ RunSection, decodeKind, decodeLimit }) => {
    const moves = [move(3, 2, { kind: 2, limit: 5, processOn: true, length_mm: 20 }), move(4, 1, { kind: 0 }), move(9, 1, { length_mm: 0 })];
    const section = new RunSection(100, leanMessage(moves, 100, 7), 0, undefined);
    assert.deepEqual([section.count, section.start_s, section.end_s, section.whole], [3, 7, 11, null]);
    assert.deepEqual([0, 1, 2].map((vertex) => section.vertexSegment(vertex)), [100, 101, 102]);
    const flags = section.vertexFlags(0);
    assert.deepEqual([decodeKind(flags), decodeLimit(flags), flags & 4, decodeKind(section.vertexFlags(1)), section.vertexFlags(1) & 4], [2, 5, 4, 0, 0]);
    assert.ok(Math.abs(section.vertexSpeed_mm_s(0) / 10 - 1) < 0.05);
    assert.equal(section.vertexSpeed_mm_s(2), 0);
    assert.deepEqual(section.tip_mm(10.5).map((value) => Math.round(10 * value) / 10), [102.5, 0, 0]);
  },

  "lines of a lean stretch, and the other way round": ({ RunSection }) => {
    const moves = [...lines(5, 3), move(20, 1), move(18, 1), move(16, 1), move(16, 1), move(16, 1), move(3, 1, { file: 1 })];
    const section = new RunSection(0, leanMessage(moves), 0, undefined);
    assert.deepEqual(moves.map((_, i) => section.lineOf(i)), moves.map(({ line, file = 0 }) => ({ file, line })));
    assert.deepEqual([...section.segmentsOf({ file: 0, line: 6 })], [1]);
    assert.deepEqual([...section.segmentsOf({ file: 0, line: 18 })], [4]);
    assert.deepEqual([...section.segmentsOf({ file: 0, line: 19 })], []);
    assert.deepEqual([...section.segmentsOf({ file: 1, line: 3 })], [8]);
    assert.deepEqual([section.blockAround(6), section.blockAround(5), section.blockAround(0)], [[5, 8], [5, 8], [0, 1]]);
  },

  "what is here for good comes first; behind it the segment under way is told by vertices": (page) => {
    const { segments } = longRunOf(page, PARTS).robots[0];
    assert.deepEqual([segments.count, segments.isLong, segments.chunks.length, segments.sections.length], [16, true, 1, 4]);
    assert.deepEqual([0.5, 4, 4.5, 7.9, 15.5, 99].map((t_s) => segments.at(t_s)), [0, 4, 4, 7, 15, 15]);
    assert.deepEqual([segments.info(2).line, segments.info(5), segments.joints_at(5.5), segments.speed_at(5.5)], [3, null, null, null]);
    assert.deepEqual([segments.lineOf(5).line, segments.start_s(5), segments.segmentEnd_s(5), segments.end_s], [6, 5, 6, 16]);
    assert.equal(longRunOf(page, PARTS).robots[0].axes_at(5.5), null);
    near(segments.tip_mm(5.5)[0], 5.5, 1e-6);
  },

  "a wait that is not here is no move, and no line that it may not be of": async (page) => {
    const wait = (line, duration_s) => move(line, duration_s, { kind: 4, isStationary: true, to: [line, 0] });
    // From 4 s on: 1 s on line 5, 2 s of waiting on 6, 1 s on 7, then on 8 waiting and 1 s of moving, and waiting on 9 and 10.
    const parts = [lines(1, 4), [move(5, 1), wait(6, 2), move(7, 1), wait(8, 1), move(8, 1), wait(9, 1), wait(10, 1)], [move(11, 1), wait(12, 2)]];
    const run = longRunOf(page, parts);
    const { segments } = run.robots[0];
    const kind_at = (t_s) => {
      const flags = segments.flagsAt(t_s);
      return flags === null ? null : page.decodeKind(flags);
    };
    const line_at = (t_s) => run.locationOfMotion(0, t_s)?.line ?? null;
    const instants_s = [3.5, 4.5, 5.5, 6.9, 7.5, 8.5, 9.5, 10.5, 11.5, 12.5, 13.5, 14.5];
    assert.deepEqual(instants_s.map(kind_at), [1, 1, null, null, null, null, null, null, null, 1, null, null]);
    assert.deepEqual(instants_s.map(line_at), [4, 5, null, null, null, 8, 8, null, null, 11, 12, 12]);
    assert.deepEqual([5.5, 10.5, 14.5].map((t_s) => segments.at(t_s)), [6, 10, 12], "the move behind, or the last");
    for (const index of [4, 12]) await segments.fetchNow(index);
    assert.deepEqual(instants_s.map(kind_at), [1, 1, 4, 4, 1, 4, 1, 4, 4, 1, 4, 4]);
    assert.deepEqual(instants_s.map(line_at), [4, 5, 6, 6, 7, 8, 8, 9, 10, 11, 12, 12]);
    assert.deepEqual([kind_at(15.5), segments.at(99)], [null, 12]);
  },

  "laws are fetched when an instant is shown, and are those of that instant": async (page) => {
    const asked = [];
    const run = longRunOf(page, PARTS, { fetched: (number) => asked.push(number) });
    const store = displayed(page, run);
    const [robot] = run.robots;
    store.set("time_s", 2);
    assert.deepEqual(asked, []);
    store.set("time_s", 9.25);
    await soon();
    assert.deepEqual([asked, store.get("loadCount")], [[2], 1]);
    const whole = runOf(page, PARTS.flat()).robots[0];
    for (const t_s of [8, 8.5, 9.25, 11.999]) assert.deepEqual(robot.joints_at(t_s), whole.joints_at(t_s));
    assert.deepEqual([robot.segments.info(9).line, robot.segments.speed_at(9.25)], [10, whole.segments.speed_at(9.25)]);
    store.set("time_s", 10);
    await soon();
    assert.deepEqual(asked, [2], "it is here");
    store.set("playing", true);
    await soon();
    assert.deepEqual(asked, [2, 3], "what comes next");
  },

  "of many instants that are passed the last one counts": async (page) => {
    const asked = [];
    const run = longRunOf(page, PARTS, { whole: 0, fetched: (number) => asked.push(number) });
    for (const t_s of [1, 5, 9, 13]) run.prefetch(t_s);
    for (let i = 0; i < 4; ++i) await soon();
    assert.deepEqual(asked, [0, 3]);
  },

  "a few are kept, those that were looked at last": async (page) => {
    const parts = Array.from({ length: 6 }, (_, i) => lines(4 * i + 1, 4));
    const messages = new Map();
    let before;
    const sections = parts.map((moves, i) => (before = new page.RunSection(4 * i, leanMessage(moves, 4 * i, 4 * i), i, before)));
    const whole = longRunOf(page, parts, { whole: 6 });
    whole.robots[0].segments.chunks.forEach((chunk, i) => messages.set(i, chunk));
    const asked = [];
    const laws = new page.ChunkCache(async (number) => {
      asked.push(number);
      const chunk = messages.get(number);
      return { is: "segments", header: { first: chunk.first }, columns: new Map(Object.entries(chunk)) };
    }, 3);
    for (const i of [0, 1, 2]) assert.equal(await laws.fetchNow(sections[i]), true);
    assert.equal(laws.get(sections[0]).first, 0);
    await laws.fetchNow(sections[3]);
    assert.deepEqual([laws.count, laws.get(sections[1])], [3, null]);
    assert.deepEqual([0, 2, 3].map((i) => laws.get(sections[i])?.first), [0, 8, 12]);
    await Promise.all([laws.fetchNow(sections[1]), laws.fetchNow(sections[1])]);
    assert.deepEqual([asked, laws.count], [[0, 1, 2, 3, 1], 3]);
  },

  "those of another run are not taken, and why none came is said": async (page) => {
    const said = [];
    const run = longRunOf(page, PARTS, {
      fetched: (number) => {
        if (number === 2) throw new Error("it has ended");
      },
    });
    run.laws.failed = (why) => said.push(why);
    assert.equal(await run.robots[0].segments.fetchNow(9), false);
    assert.deepEqual([said, run.robots[0].joints_at(9.5)], [["it has ended"], null]);
    assert.equal(await run.robots[0].segments.fetchNow(5), true, "the next one is asked for all the same");
    const other = longRunOf(page, PARTS.map((part) => part.slice(1)));
    const section = new page.RunSection(3, leanMessage(lines(5, 4), 3, 4), 1, undefined);
    other.laws.failed = (why) => said.push(why);
    assert.equal(await other.laws.fetchNow(section), false);
    assert.match(said[1], /another run/);
  },

  "blocks behind the table: of a line, of an instant, before and after": async (page) => {
    // Lines 2 and 3 alternate; a block of three segments crosses the end of a stretch.
    const loop = [move(2, 1), move(3, 1), move(2, 1), move(3, 1)];
    const run = longRunOf(page, [loop, loop, [move(2, 1), move(7, 1), move(7, 1)], [move(7, 1), move(8, 1)]]);
    const { blocks, segments } = run.robots[0];
    assert.deepEqual([blocks.tabled, [...blocks.blocksOfLine(0, 2)], [...blocks.behindTable({ file: 0, line: 2 })]], [4, [0, 2], [4, 6, 8]]);
    assert.deepEqual([9, 10, 11, 12].map((segment) => blocks.of(segment)), [9, 9, 9, 12]);
    assert.deepEqual([blocks.first(9), blocks.end(9), blocks.after(9), blocks.before(12), blocks.before(4), blocks.after(12)], [9, 12, 12, 9, 3, -1]);
    assert.deepEqual([...blocks.behindTable({ file: 0, line: 7 })], [9], "once");
    assert.deepEqual([blocks.firstOf(0, 7), blocks.firstOf(0, 2), blocks.firstOf(1, 2)], [9, 0, -1]);
    assert.deepEqual([0.5, 3, 4.5, 5.9, 6.5, 20].map((t_s) => blocks.nearest(0, 2, t_s)), [0, 2, 4, 6, 6, 8]);
    assert.deepEqual(blocks.get(9), { file: 0, line: 7, first: 9, count: 3, start_s: 9, end_s: 12 });
    assert.equal(page.blockSummary(run.robots[0], 0, 2), null, "not all of the line is here");
    assert.deepEqual([2, 77].map((line) => page.isSummaryIncomplete(run.robots[0], 0, line)), [true, false]);
    assert.equal(await segments.fetchNow(9), true);
    assert.equal(blocks.end_s(9), 12);
  },

  "steps go on from block to block behind the table, when they are here": async (page) => {
    const store = displayed(page, longRunOf(page, PARTS));
    store.set("time_s", 3.5);
    const step = async (by) => {
      page.stepBlock(store, by);
      for (let i = 0; i < 3; ++i) await soon();
      return store.get("time_s");
    };
    assert.deepEqual([await step(1), await step(1), await step(1), await step(-1)], [4, 5, 6, 5]);
    store.set("time_s", 12);
    assert.deepEqual([await step(-1), await step(1), await step(1)], [11, 12, 13]);
    page.goToBlock(store, 9);
    assert.deepEqual(store.get("selection"), { file: "a.nc", line: 10, block: 9 });
    assert.deepEqual([store.get("time_s"), page.activeLine(store).line], [9, 10]);
  },

  "vertices of a long way know their segments, lines and colours": (page) => {
    const parts = [lines(1, 4), lines(5, 4, { kind: 0, processOn: true }), lines(9, 4, { length_mm: 50 })];
    const run = longRunOf(page, parts);
    const { segments } = run.robots[0];
    const data = new page.PathData(segments);
    assert.deepEqual([data.count, data.vertexSegment(9), data.isRapid(5), data.isRapid(9), data.at(8.5)], [12, 9, true, false, 8]);
    assert.deepEqual(data.vertexRange(5, 7), [5, 7]);
    assert.deepEqual([...data.vertices(3, 9)].map(({ from, to, vertex }) => [from, to, vertex]), [[3, 4, 3], [0, 4, 4], [0, 1, 8]]);
    assert.deepEqual(page.legendKey("kind", [segments]).classes, ["rapid", "linear"]);
    assert.ok(Math.abs(page.legendKey("speed", [segments]).scale.high / 50 - 1) < 0.05);
    assert.deepEqual(["speed", "feed", "kind"].map((mode) => page.legendKey(mode, [segments]).isPartial), [false, true, false]);
    const texels = page.colourTexels(data, page.legendKey("kind", [segments]), 0, 12);
    assert.deepEqual([3, 4, 8].map((vertex) => texels[4 * vertex + 3]), [0, page.RAPID_MARK, 0]);
    assert.deepEqual([...page.processEdges_s(segments)], [4, 8]);
    const state = { selection: { file: "a.nc", line: 10, block: -1 }, robot: 0 };
    assert.deepEqual(page.selectedRanges(run, 0, data, state), [[9, 10]]);
  },

  "a way that has grown is that of its end": (page) => {
    const run = longRunOf(page, PARTS.slice(0, 2));
    const { segments } = run.robots[0];
    const data = new page.PathData(segments);
    run.addMessage(leanMessage(PARTS[2], 8, 8));
    assert.equal(data.count, 8);
    data.grow();
    assert.deepEqual([data.count, data.bounds.max.x, data.vertexSegment(11)], [12, 12, 11]);
  },

  "over much of a long run charts have mean speeds, over little what is exact": (page) => {
    const many = Array.from({ length: 40 }, (_, i) => lines(4 * i + 1, 4, { length_mm: i === 30 ? 40 : 10 }));
    const { segments } = longRunOf(page, many).robots[0];
    assert.deepEqual([page.needsOverview(segments, 0, 160), page.needsOverview(segments, 20, 30)], [true, false]);
    const { t_s, values } = page.overviewCurves(segments, "path", 3, 0, 160, 80);
    assert.deepEqual([t_s.length, values[page.PATH.acceleration].every(Number.isNaN)], [160, true]);
    const speeds = values[page.PATH.speed];
    assert.ok(Math.abs(Math.max(...speeds) / 40 - 1) < 0.05 && Math.abs(Math.min(...speeds) / 10 - 1) < 0.05);
    assert.ok(Math.abs(t_s[speeds.indexOf(Math.max(...speeds))] - 121) < 2);
    assert.deepEqual(page.overviewCurves(segments, "position", 2, 0, 160, 80).t_s, []);
  },

  "of a way that lies in few pixels fewer pieces are drawn, of one beside the screen none": ({ rowStrides, rowLength }) => {
    const identity = { elements: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1] };
    /** Returns the lines of a zigzag in a square around the middle of the screen, which is 2 mm wide. */
    const zigzag = (count, half_mm, at = 0) => {
      const texels = new Float32Array(4 * (count + 1));
      for (let i = 0; i <= count; ++i) {
        texels[4 * i] = at + (i % 2 ? half_mm : -half_mm);
        texels[4 * i + 1] = half_mm * ((2 * i) / count - 1);
      }
      return rowLength(texels, 0, count);
    };
    const strides = (...rows) => [...rowStrides(rows, identity, 1000, 1000)];
    const row = zigzag(1000, 0.5);
    assert.deepEqual([row.pieces, row.low.slice(0, 2), row.high.slice(0, 2)], [1000, [-0.5, -0.5], [0.5, 0.5]]);
    near(row.length_mm, 1000, 1);
    assert.deepEqual(strides(zigzag(100, 0.5)), [1]);
    assert.deepEqual(strides(zigzag(100, 0.5, 5)), [0]);
    // 20 rows with 500,000 pixels of path each on 250,000 pixels: forty times as much.
    assert.deepEqual(new Set(strides(...Array.from({ length: 20 }, () => row))), new Set([4]));
    // All in one pixel.
    assert.deepEqual(strides(zigzag(4096, 1e-5)), [64]);
    // An isolated path away from all others is drawn completely.
    const alone = zigzag(20, 0.1, 0.85);
    assert.equal(strides(...Array.from({ length: 20 }, () => row), alone).at(-1), 1);
  },
};

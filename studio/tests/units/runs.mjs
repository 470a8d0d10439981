// Blocks, active lines, marks, and the queries of the page for them.

import assert from "node:assert/strict";
import { near, runOf, segmentsMessage } from "./made.mjs";

export const modules = [
  ...["run/run", "run/segments", "run/blocks", "run/marks", "run/limits", "run/search", "run/report"],
  ...["core/store", "core/navigation", "core/display_state", "time/steps", "time/process", "code/line_times", "code/block_summary"],
];

const move = (line, duration_s, more = {}) => ({ line, duration_s, ...more });

/** Line 2 and 3 three times in a loop, a subprogram in file 1 between, line 9 last; 2 s, 1 s, 1 s, ... */
const passes = [2, 1, 3].flatMap((duration_s, i) => [move(2, duration_s), move(2, 1), move(3, 1), move(i + 5, 1, { file: 1 })]);
const looped = (page) => runOf(page, [...passes, move(9, 4)], { files: { "main.nc": "", "sub.nc": "" } });

function displayed(page, run) {
  const store = new page.Store(page.initialState());
  store.set("run", run);
  return store;
}

export default {
  "the last index for which something holds": ({ lastIndex }) => {
    for (const count of [0, 1, 2, 7, 100]) {
      for (let end = 0; end <= count; ++end) assert.equal(lastIndex(count, (i) => i < end), end - 1);
    }
  },

  "the segment under way at a time, over several messages": ({ Segments }) => {
    const segments = new Segments(2, [0, 1]);
    assert.equal(segments.at(1), -1);
    segments.add(segmentsMessage([move(1, 1), move(2, 1)]));
    segments.add(segmentsMessage([move(3, 1), move(4, 0), move(5, 1)], 2, 2));
    assert.deepEqual([-1, 0, 0.99, 1, 2.5, 3, 4, 99].map((t_s) => segments.at(t_s)), [0, 0, 0, 1, 2, 4, 4, 4]);
    assert.equal(segments.info(2).line, 3);
    assert.equal(segments.end_s, 4);
    near(segments.joints_at(0.25).position[0], 0.25);
    near(segments.speed_at(0.5), 1);
    assert.equal(segments.speed_at(4), 0);
  },

  "flags say kind, limit and axis of a segment": ({ Segments, isRapid, limitOfFlags }) => {
    const segments = new Segments(2, [0, 1]);
    segments.add(segmentsMessage([move(1, 1, { kind: 0, limit: 2, axis: 1, processOn: true }), move(2, 1, { kind: 4 })]));
    const { kind, limit, limitAxis, processOn } = segments.info(0);
    assert.deepEqual([kind, limit, limitAxis, processOn], ["rapid", "joint_speed", 1, true]);
    const [first, second] = segments.chunks[0].flags;
    assert.equal(isRapid(first), true);
    assert.deepEqual(limitOfFlags(first, ["X", "C"]), { kind: "joint_speed", letter: "C" });
    assert.deepEqual(limitOfFlags(second, ["X", "C"]), { kind: "dwell", letter: "" });
    assert.deepEqual(limitOfFlags(first | 3, ["X", "C"]), { kind: "dwell", letter: "" }, "a control waits within a move");
  },

  "segments of a line one behind the other are a block, and each pass of a loop is one": (page) => {
    const { blocks } = looped(page).robots[0];
    assert.equal(blocks.tabled, 10);
    assert.deepEqual([...blocks.blocksOfLine(0, 2)], [0, 3, 6]);
    assert.deepEqual([...blocks.blocksOfLine(1, 6)], [5]);
    assert.deepEqual([...blocks.blocksOfLine(0, 77)], []);
    assert.deepEqual([0, 1, 2, 3, 12].map((segment) => blocks.of(segment)), [0, 0, 1, 2, 9]);
    const { line, first, count, start_s, end_s } = blocks.get(3);
    assert.deepEqual({ line, first, count, start_s, end_s }, { line: 2, first: 4, count: 2, start_s: 5, end_s: 7 });
    assert.deepEqual([blocks.after(3), blocks.before(3), blocks.after(9), blocks.before(0)], [4, 2, -1, -1]);
    assert.deepEqual([blocks.firstOf(0, 3), blocks.firstOf(0, 77)], [1, -1]);
    assert.equal(blocks.end_s(9), 19);
  },

  "the block of a line at a time, else the nearest": (page) => {
    const { blocks } = looped(page).robots[0];
    // Line 2 runs from 0 to 3, from 5 to 7 and from 9 to 13 s.
    const at = (t_s) => blocks.nearest(0, 2, t_s);
    assert.deepEqual([-1, 0, 2, 3, 3.5, 4.9, 5, 6, 7, 7.5, 8.5, 13, 18].map(at), [0, 0, 0, 0, 3, 3, 3, 3, 3, 6, 6, 6, 6]);
    assert.equal(blocks.nearest(0, 77, 1), -1);
    assert.equal(blocks.nearest(-1, 2, 1), -1);
  },

  "at an event's time the line at work is the event's, else the motion's": (page) => {
    const events = [
      { t_s: 3, kind: "jet_on", file: "main.nc", line: 1 },
      { t_s: 1, kind: "start", file: null, line: null },
    ];
    const run = runOf(page, [move(2, 3), move(4, 1)], { files: { "main.nc": "" }, report: { events } });
    const lines = (t_s) => run.locationsAt(0, t_s).map(({ line }) => line);
    assert.deepEqual([0, 1, 3, 3.0000000004, 3.1, 4, 4.1].map(lines), [[2], [2], [1], [1], [4], [4], []]);
    const store = displayed(page, run);
    store.set("time_s", 3);
    assert.equal(page.activeLine(store).line, 1);
    store.set("selection", { file: "main.nc", line: 4, block: -1 });
    assert.equal(page.activeLine(store).line, 4, "what a person has chosen there");
    store.set("robot", 5);
    assert.equal(page.activeLine(store), null);
  },

  "going to a mark chooses the pass of its line": (page) => {
    const store = displayed(page, looped(page));
    page.goTo(store, { file: "main.nc", line: 3 }, 7.5);
    assert.deepEqual(store.get("selection"), { file: "main.nc", line: 3, block: 4 });
    assert.equal(store.get("time_s"), 7.5);
    page.goTo(store, { file: "other.nc", line: 3 }, null);
    assert.equal(store.get("selection").block, -1);
    page.goToBlock(store, 5);
    assert.deepEqual([store.get("time_s"), store.get("selection")], [8, { file: "sub.nc", line: 6, block: 5 }]);
  },

  "steps go from block to block, and back to a block's own start": (page) => {
    const store = displayed(page, looped(page));
    const steps = (by, count) => Array.from({ length: count }, () => (page.stepBlock(store, by), store.get("time_s")));
    assert.deepEqual(steps(1, 11), [3, 4, 5, 7, 8, 9, 13, 14, 15, 19, 19]);
    store.set("time_s", 8.5);
    assert.deepEqual(steps(-1, 3), [8, 7, 5]);
  },

  "steps to marks find the next on either side": (page) => {
    const marks = [1, 2, 2, 5].map((t_s) => ({ t_s, file: null, line: null }));
    const store = displayed(page, looped(page));
    assert.deepEqual([0, 1, 2, 6].map((t_s) => page.firstAfter(marks, t_s)), [0, 1, 3, 4]);
    store.set("time_s", 2);
    assert.equal(page.stepMark(store, marks, 1).t_s, 5);
    assert.equal(page.stepMark(store, marks, 1), null);
    assert.equal(page.stepMark(store, marks, -1).t_s, 2);
  },

  "marks are in the order of time, and clearances of nothing are contacts": (page) => {
    const place = { file: "a.nc", line: 2 };
    const pair = ["nozzle", "clamp"];
    const report = {
      events: [{ ...place, t_s: 2, kind: "jet_on" }],
      collisions: [{ ...place, t_s: 1, kind: "touching", pair, point_mm: [0, 0, 0] }],
      clearances: [
        { ...place, clearance_mm: 3, pair, point_mm: [0, 0, 0] },
        { ...place, clearance_mm: 0, pair, point_mm: [0, 0, 0] },
      ],
      violations: [{ ...place, t_s: 3, zone: "door", message: "too far" }, { ...place, t_s: 3.5, zone: null, message: "end" }],
      alarm: { ...place, code: "x", message: "stopped", axis: null },
    };
    const marks = page.runMarks(runOf(page, [move(1, 0.5), move(2, 4)], { report }), 0);
    assert.deepEqual(marks.map(({ kind }) => kind), ["near", "collision", "event", "zone", "violation", "alarm"]);
    assert.deepEqual(marks.map(({ t_s }) => t_s), [0.5, 1, 2, 3, 3.5, 4.5]);
  },

  "a robot's report is its own, where there are several": (page) => {
    const run = runOf(page, [move(1, 1)], { report: { robots: [{ name: "left" }, { name: "right" }] } });
    assert.equal(run.reportOf(1).name, "right");
    assert.equal(runOf(page, [move(1, 1)], { report: { program: "a.nc" } }).reportOf(0).program, "a.nc");
  },

  "the process is on where segments say so": ({ Segments, processEdges_s, isProcessOnWithin }) => {
    const segments = new Segments(2, [0, 1]);
    segments.add(segmentsMessage([0, 1, 1, 0, 1].map((on) => move(1, 1, { processOn: on === 1 }))));
    const edges_s = processEdges_s(segments);
    assert.deepEqual([...edges_s], [1, 3, 4, 5]);
    const within = (from_s, to_s) => isProcessOnWithin(edges_s, from_s, to_s);
    assert.deepEqual([within(0, 0.9), within(0, 1.1), within(1.5, 1.6), within(3, 3.9), within(3.5, 9), within(5, 9)], [false, true, true, false, true, false]);
  },

  "times of lines add up over all passes": (page) => {
    const robot = looped(page).robots[0];
    const { times_s, slowest_s } = page.lineTimes(robot, 0);
    assert.deepEqual([times_s[2], times_s[3], times_s[9]], [9, 3, 4]);
    assert.equal(slowest_s, 9);
  },

  "what is told of a line: passes, time, length and what held it back for longest": (page) => {
    const moves = [move(4, 1, { limit: 6 }), move(4, 3, { limit: 3, axis: 0 }), move(5, 1), move(4, 1, { limit: 6 })];
    const facts = page.blockSummary(runOf(page, moves).robots[0], 0, 4);
    assert.deepEqual([facts.passes, facts.time_s, facts.length_mm], [2, 5, 3]);
    assert.deepEqual(facts.limit, { kind: "acceleration", letter: "X" });
    near(facts.peak_mm_s, 1);
    assert.equal(page.blockSummary(runOf(page, moves).robots[0], 0, 6), null);
  },
};

// Inputs of the result tables: blocks sorted and filtered, runs compared, shares of time.

import assert from "node:assert/strict";
import { near, runOf } from "./made.mjs";

const data = ["block_table", "comparison", "diff", "filter", "largest_indices", "limit_texts", "operations", "source_lines", "tools"];

export const modules = [...data.map((name) => `panels/results/data/${name}`), "run/run"];

const move = (line, duration_s, more = {}) => ({ line, duration_s, ...more });

const source = "N10 G0 X1\n(ROUGHING)\nN20 G1 X2 F600\nN30 G4 P1\n(FINISHING)\n(side)\nN40 G1 X9\nN200 G2 X1 I4\n";
const moves = [
  move(1, 1, { kind: 0, limit: 2, axis: 0 }),
  move(3, 2, { feed_per_min: 600 }),
  move(3, 5, { limit: 3, axis: 0, feed_per_min: 900 }),
  move(4, 1, { kind: 4, limit: 10, length_mm: 0, feed_per_min: 0 }),
  move(7, 3, { limit: 6 }),
  move(8, 3, { kind: 2, limit: 5 }),
];

const program = (page) => runOf(page, moves, { files: { "a.nc": source } });

/** Numbers of the blocks that match. */
function found(page, words) {
  const run = program(page);
  const [robot] = run.robots;
  const table = page.cachedBlockTable(robot);
  const passes = page.createFilter(words, run, robot, table);
  return Array.from({ length: table.count }, (_, block) => block).filter(passes);
}

const compared = (page, before, after, most = 100) => {
  const runs = [before, after].map(([text, ...times]) =>
    runOf(page, times.map(([line, duration_s]) => move(line, duration_s)), { files: { "a.nc": text } }),
  );
  return page.compare(...runs, 0, most);
};

const matched = ({ SourceLines, matchLines }, before, after) => {
  const { before: from, changed } = matchLines(new SourceLines(before.join("\n")), new SourceLines(after.join("\n")));
  return Array.from(after, (_, i) => (changed[i + 1] ? -from[i + 1] : from[i + 1]));
};

export default {
  "the table has each block once, by its longest piece": (page) => {
    const [robot] = program(page).robots;
    const table = page.cachedBlockTable(robot);
    assert.deepEqual([...table.line], [1, 3, 4, 7, 8]);
    assert.deepEqual([...table.duration_s], [1, 7, 1, 3, 3]);
    assert.deepEqual([...table.length_mm], [1, 2, 0, 1, 1]);
    assert.equal(table.total_s, 15);
    assert.equal(table.feed_per_min[1], 900);
    assert.deepEqual(page.blockLimit(table, 1, ["X", "C"]), { kind: "acceleration", letter: "X" });
    assert.deepEqual(page.blockLimit(table, 2, ["X", "C"]), { kind: "dwell", letter: "" });
    near(table.meanSpeed_mm_s(1), 2 / 7);
    assert.equal(page.cachedBlockTable(robot), table, "made once");
  },

  "the greatest come first, of equals the earlier": ({ largestIndices }) => {
    const keys = [3, 9, 1, 9, 4, 7, 3, 0];
    const first = (most, passes = () => true) => [...largestIndices(keys.length, most, (i) => keys[i], passes).indices];
    assert.deepEqual(first(3), [1, 3, 5]);
    assert.deepEqual(first(6), [1, 3, 5, 4, 0, 6]);
    assert.deepEqual(first(99), [1, 3, 5, 4, 0, 6, 2, 7]);
    assert.deepEqual(first(2, (i) => i % 2 === 0), [4, 0]);
    assert.deepEqual(first(0), []);
    assert.equal(largestIndices(keys.length, 2, (i) => keys[i], (i) => keys[i] > 2).passed, 6);
  },

  "the greatest of many are those of sorting them all": ({ largestIndices }) => {
    let seed = 1;
    const keys = Array.from({ length: 5000 }, () => (seed = (seed * 48271) % 2147483647) % 500);
    const sorted = keys.map((_, i) => i).sort((a, b) => keys[b] - keys[a] || a - b);
    assert.deepEqual([...largestIndices(keys.length, 300, (i) => keys[i], () => true).indices], sorted.slice(0, 300));
  },

  "a number finds its line and its N word, two numbers the lines between": (page) => {
    assert.deepEqual(found(page, "3"), [1]);
    assert.deepEqual(found(page, "20"), [1]);
    assert.deepEqual(found(page, "4 - 7"), [2, 3]);
    assert.deepEqual(found(page, "2000"), []);
  },

  "words find text, kinds of motion and limits": (page) => {
    assert.deepEqual(found(page, ""), [0, 1, 2, 3, 4]);
    assert.deepEqual(found(page, "g1 x"), [1, 3]);
    assert.deepEqual(found(page, "arc CW"), [4]);
    assert.deepEqual(found(page, "rapid"), [0]);
    assert.deepEqual(found(page, "acceleration of x"), [1]);
    assert.deepEqual(found(page, "speed of"), [0]);
    assert.deepEqual(found(page, "corner"), [3]);
    assert.deepEqual(found(page, "dwell"), [2]);
    assert.deepEqual(found(page, "nothing like this"), []);
  },

  "lines of a source, whatever ends them": ({ SourceLines }) => {
    const lines = new SourceLines("a\r\n  b\n\nc");
    assert.deepEqual([lines.count, ...[0, 1, 2, 3, 4, 5].map((line) => lines.line(line))], [4, "", "a", "  b", "", "c", ""]);
    assert.deepEqual([1, 2, 3, 4].map((line) => lines.firstCharacter(line)), ["a", "b", "", "c"]);
    assert.deepEqual([...new SourceLines("ab\nx\nAB ab\n").linesWith("ab")], [0, 1, 0, 1, 0]);
  },

  "a diff pairs what stayed, what changed in its place, and nothing else": (page) => {
    assert.deepEqual(matched(page, ["a", "b", "c"], ["a", "b", "c"]), [1, 2, 3]);
    assert.deepEqual(matched(page, ["a", "b", "c"], ["a", "B", "c"]), [1, -2, 3]);
    assert.deepEqual(matched(page, ["a", "b", "c"], ["a", "x", "b", "c"]), [1, 0, 2, 3]);
    assert.deepEqual(matched(page, ["a", "b", "c", "d"], ["a", "d"]), [1, 4]);
    assert.deepEqual(matched(page, ["a", "b"], ["b", "a"]).filter((line) => line > 0).length, 1);
    assert.deepEqual(matched(page, ["a", "b", "a", "c"], ["a", "x", "a", "c", "a"]), [1, -2, 3, 4, 0]);
    assert.deepEqual(matched(page, [], ["a"]), [-1], "an empty text has one empty line");
  },

  "a diff of long texts finds lines by those that stand once": (page) => {
    const before = Array.from({ length: 3000 }, (_, i) => `X${i}`);
    const after = [...before.slice(0, 100), "new", ...before.slice(100, 2000).map((line, i) => (i === 700 ? "changed" : line)), ...before.slice(2001)];
    const pairs = matched(page, before, after);
    assert.deepEqual([pairs[99], pairs[100], pairs[101], pairs[801], pairs[802], pairs[2000], pairs[2001], pairs.at(-1)], [100, 0, 101, -801, 802, 2000, 2002, 3000]);
  },

  "two runs are compared by lines, also where lines came before them": (page) => {
    const before = ["G1 X1\nG1 X2\nG1 X3\n", [1, 1], [2, 2], [3, 3]];
    const after = ["(new)\nG1 X1\nG1 X2 F9\nG1 X3\nG1 X4\n", [2, 1], [3, 5], [4, 3], [5, 0.5]];
    const { rows, count, before_s, after_s } = compared(page, before, after);
    assert.deepEqual([before_s, after_s, count], [6, 9.5, 2]);
    assert.deepEqual(rows.map(({ change, line, before_s: was, after_s: is }) => [change, line, was, is]), [["changed", 3, 2, 5], ["new", 5, 0, 0.5]]);
    assert.equal(compared(page, after, before, 1).rows.length, 1);
    assert.deepEqual(compared(page, after, before).rows.map(({ change, line }) => [change, line]), [["changed", 2], ["gone", 5]]);
    assert.equal(compared(page, before, before).count, 0);
  },

  "comments that stand alone name the operations behind them": (page) => {
    const run = program(page);
    const [robot] = run.robots;
    const operations = page.timeByOperation(run, robot, page.cachedBlockTable(robot), "unnamed");
    assert.deepEqual(operations, [
      { name: "unnamed", time_s: 1, first: 0 },
      { name: "ROUGHING", time_s: 8, first: 1 },
      { name: "FINISHING, side", time_s: 6, first: 3 },
    ]);
  },

  "each tool has the time until the next comes in": ({ timeByTool }) => {
    const change = (t_s, detail) => ({ t_s, kind: "tool_change", detail });
    const events = [change(1, "T1"), { t_s: 2, kind: "tool_select", detail: "T7" }, change(4, "T2"), change(6, "T1")];
    assert.deepEqual(timeByTool({ events, cycle_time_s: 10 }), [
      { name: "", time_s: 1, start_s: 0 },
      { name: "T1", time_s: 7, start_s: 1 },
      { name: "T2", time_s: 2, start_s: 4 },
    ]);
    assert.deepEqual(timeByTool({ cycle_time_s: 10 }), []);
  },
};

// Variants: their file, which blocks of two runs belong together, and what the difference is made of.

import assert from "node:assert/strict";
import { near, runOf } from "./made.mjs";

export const modules = [
  ...["differences", "matching", "results", "variants_file"].map((name) => `panels/variants/data/${name}`),
  ...["run/run", "core/setup", "core/run_snapshot", "core/documents"],
];

const move = (line, duration_s, more = {}) => ({ line, duration_s, ...more });
const side = (run) => ({ run, robot: run.robots[0] });
const finished = { status: "completed" };

const source = "G21\nG1 X1\nG1 X2\nG1 X3\nG1 X4\nM2\n";
const made = (page, moves, files = { "a.nc": source }) => runOf(page, moves, { files, report: finished });
const between = (page, one, other, from = null) => new page.Differences(side(one), side(other), from);

/** Kind, line, pass and times of each row. */
const plain = ({ rows }) => rows.map(({ kind, line, pass, times_s }) => [kind, line, pass, ...times_s]);

/** A subprogram of two lines that is run three times, from line 2; then line 5. */
const looped = (page, times) =>
  made(page, [...times.flatMap(([first, second]) => [move(2, first), move(3, second)]), move(5, 4)]);

export default {
  "blocks belong together by line and pass, and their differences make the whole": (page) => {
    const one = looped(page, [[1, 1], [1, 1], [1, 1]]);
    const other = looped(page, [[1, 1], [1, 3], [0.5, 1]]);
    const found = between(page, one, other);
    assert.deepEqual(plain(found.rows(10)), [["both", 3, 2, 1, 3], ["both", 2, 3, 1, 0.5]]);
    assert.deepEqual(found.totals_s, [10, 11.5]);
    near(found.total_s, 1.5);
    near(found.blockDifference_s, 1.5);
    assert.equal(found.rows(10).rows[0].passes, 3);
  },

  "the other way round the same blocks differ by as much the other way": (page) => {
    const one = looped(page, [[1, 1], [2, 1], [1, 1]]);
    const other = looped(page, [[1, 1], [1, 3], [0.5, 1]]);
    const swapped = between(page, other, one).rows(10).rows;
    const rows = between(page, one, other).rows(10).rows;
    assert.deepEqual(swapped.map(({ line, pass, times_s }) => [line, pass, ...times_s]), rows.map(({ line, pass, times_s }) => [line, pass, times_s[1], times_s[0]]));
  },

  "each block of either run is in exactly one pair": (page) => {
    const one = looped(page, [[1, 1], [2, 1]]);
    const other = looped(page, [[1, 2], [3, 3], [4, 5]]);
    const { blocksOfA, blocksOfB } = page.matchBlocks(side(one), side(other));
    blocksOfA.forEach((b, a) => b >= 0 && assert.equal(blocksOfB[b], a));
    assert.equal(blocksOfA.filter((b) => b >= 0).length, blocksOfB.filter((a) => a >= 0).length);
    assert.equal(blocksOfA.length, 5);
    assert.deepEqual([...blocksOfB], [0, 1, 2, 3, -1, -1, 4]);
  },

  "a pass that one run alone has is its own, and counts whole": (page) => {
    const found = between(page, looped(page, [[1, 1]]), looped(page, [[1, 1], [2, 3]]));
    assert.deepEqual(plain(found.rows(10)), [["onlyB", 3, 2, 0, 3], ["onlyB", 2, 2, 0, 2]]);
    near(found.blockDifference_s, 5);
    const back = between(page, looped(page, [[1, 1], [2, 3]]), looped(page, [[1, 1]]));
    assert.deepEqual(plain(back.rows(10)), [["onlyA", 3, 2, 3, 0], ["onlyA", 2, 2, 2, 0]]);
  },

  "in another text lines are those that stand in both, or were changed in their places": (page) => {
    const changed = "G21\n(one more)\nG1 X1\nG1 X2.5\nG1 X3\nG1 X4\nM2\n";
    const one = made(page, [move(2, 1), move(3, 1), move(4, 1), move(5, 1)]);
    const other = made(page, [move(3, 1), move(4, 3), move(5, 1), move(6, 2)], { "b.nc": changed });
    const found = between(page, one, other);
    assert.deepEqual(plain(found.rows(10)), [["changed", 3, 1, 1, 3], ["both", 5, 1, 1, 2]]);
    assert.deepEqual(found.matching.otherTexts, [{ a: "a.nc", b: "b.nc" }]);
    assert.deepEqual(between(page, one, one).matching.otherTexts, []);
  },

  "a text that is not in the page is said, where the names differ": (page) => {
    const one = made(page, [move(2, 1)]);
    const other = made(page, [move(2, 2)], { "b.nc": "" });
    other.sources.clear();
    assert.deepEqual(between(page, one, other).matching.unloadedTexts, [{ a: "a.nc", b: "b.nc" }]);
    assert.deepEqual(plain(between(page, one, other).rows(9)), [["both", 2, 1, 1, 2]]);
  },

  "from a block on, times and differences are those behind it": (page) => {
    const one = looped(page, [[1, 1], [1, 1], [1, 1]]);
    const other = looped(page, [[5, 1], [1, 3], [0.5, 1]]);
    const found = between(page, one, other, { file: "a.nc", line: 3, pass: 2 });
    assert.deepEqual(found.starts_s, [3, 7]);
    assert.deepEqual(found.totals_s, [7, 8.5]);
    assert.deepEqual(plain(found.rows(10)), [["both", 3, 2, 1, 3], ["both", 2, 3, 1, 0.5]]);
    near(found.blockDifference_s, found.total_s);
    assert.equal(found.reachesStart, true);
  },

  "a block that a run never comes to is told, and nothing is compared": (page) => {
    const found = between(page, looped(page, [[1, 1], [1, 1]]), looped(page, [[1, 1]]), { file: "a.nc", line: 3, pass: 2 });
    assert.deepEqual([found.reachesStart, found.startBlocks[1]], [false, -1]);
    assert.equal(found.rows(10).count, 0);
    assert.equal(page.blockOf(looped(page, [[1, 1]]).robots[0], { file: "a.nc", line: 4, pass: 1 }), -1);
  },

  "a file that the other run does not have begins where its counterpart does": (page) => {
    const one = made(page, [move(2, 1), move(3, 1), move(4, 1)]);
    const other = made(page, [move(2, 5), move(3, 2), move(4, 1)], { "b.nc": source });
    const found = between(page, one, other, { file: "b.nc", line: 3, pass: 1 });
    assert.deepEqual([found.starts_s, found.totals_s], [[1, 5], [2, 3]]);
  },

  "rows are filtered by line, by lines and by words": (page) => {
    const times = (all) => made(page, all.map((duration_s, i) => move(i + 2, duration_s)));
    const found = between(page, times([1, 1, 1, 1]), times([2, 3, 4, 5]));
    const lines = (words) => found.rows(10, words).rows.map(({ line }) => line);
    assert.deepEqual(lines(""), [5, 4, 3, 2]);
    assert.deepEqual(lines("3"), [3]);
    assert.deepEqual(lines("3 - 4"), [4, 3]);
    assert.deepEqual(lines("x4"), [5]);
    assert.deepEqual(lines("nothing"), []);
    assert.deepEqual(found.rows(1).rows.map(({ line }) => line), [5]);
    assert.equal(found.rows(1).count, 4);
  },

  "the foremost blocks go the way of the whole": (page) => {
    const times = (all) => made(page, all.map((duration_s, i) => move(i + 2, duration_s)));
    const found = between(page, times([9, 1, 5, 4]), times([1, 8, 2, 4]));
    near(found.total_s, -4);
    assert.deepEqual(found.largestDifferences(5).map(({ line }) => line), [2, 4]);
    assert.deepEqual(between(page, times([1, 8]), times([9, 1])).largestDifferences(1).map(({ line }) => line), [2]);
  },

  "time between blocks is in the whole and in none of the blocks": (page) => {
    const one = made(page, [move(2, 1), move(3, 1)]);
    const other = runOf(page, [move(2, 1), move(3, 1)], { files: { "a.nc": source }, report: { ...finished, cycle_time_s: 5 } });
    const found = between(page, one, other);
    near(found.total_s, 3);
    near(found.blockDifference_s, 0);
  },

  "a run is whole where it came to its end": (page) => {
    const of = (report) => page.isCompleteRun(runOf(page, [move(2, 1)], { report }));
    assert.deepEqual(["completed", "violations", "alarm", "stopped"].map((status) => of({ status })), [true, true, false, false]);
  },

  "a file says what differs, and gives back what was written": (page) => {
    const { writeVariants, readVariants, emptySetup } = page;
    const setup = { ...emptySetup(), program: "a.nc", machine: "m.toml", feed_override_percent: 120, collisions: false };
    const variants = [
      { name: "as it is", setup: { ...emptySetup(), program: "a.nc" }, from: null },
      { name: "fast", setup, from: { file: "a.nc", line: 3, pass: 2 } },
    ];
    const text = writeVariants(variants);
    assert.deepEqual(readVariants(text), { variants, error: "" });
    assert.deepEqual(JSON.parse(text).variants[0], { name: "as it is", program: "a.nc" });
  },

  "what a file should not have is refused by name": ({ readVariants }) => {
    const error = (variant) => readVariants(JSON.stringify({ variants: [{ name: "one" }, variant] })).error;
    assert.equal(error({ name: "two", mchine: "m" }), "variant 2: unknown key 'mchine'");
    assert.equal(error({ name: "two", feed_override_percent: "120" }), "variant 2: 'feed_override_percent' has a value of the wrong type");
    assert.equal(error({ name: "two", rapid_override_percent: 1001 }), "variant 2: 'rapid_override_percent' must be from 0 to 1000");
    assert.equal(error({ name: "two", from: { file: "a.nc", line: 0 } }), "variant 2: 'from' must have a file, a line of at least 1 and, unless it is the first, a pass");
    assert.equal(error({ name: "two", from: { file: "a.nc", line: 2, at: 1 } }), "variant 2, from: unknown key 'at'");
    assert.equal(error({ name: "one" }), "two variants have the name one");
    assert.equal(error({}), "variant 2 needs a name");
    assert.equal(error(3), "variant 2 must be an object");
    assert.equal(readVariants("[]").error, "a variants file needs a list 'variants'");
    assert.match(readVariants("{").error, /JSON/);
  },

  "runs are kept by set-up, and the oldest goes when all together are too large": (page) => {
    const documents = new page.Documents(new Map([["a.nc", source]]));
    const origins = new Map();
    const results = new page.Results({ origin: (run) => origins.get(run), changedSince: (run) => page.changedSince(run, origins.get(run), documents) }, 5);
    const ofFeed = (feed_override_percent) => ({ ...page.emptySetup(), program: "a.nc", feed_override_percent });
    const accept = (percent, run) => {
      origins.set(run, page.createSnapshot(ofFeed(percent), documents));
      results.accept(run);
      return run;
    };
    const is = (...percents) => percents.map((percent) => results.standing(ofFeed(percent)).is);
    const two = () => made(page, [move(2, 1), move(3, 1)]);
    const first = accept(100, two());
    const stopped = runOf(page, [move(2, 1)], { report: { status: "alarm" } });
    accept(50, stopped);
    assert.deepEqual(is(100, 50, 20), ["done", "stopped", "none"]);
    assert.equal(results.standing(ofFeed(100)).run, first);
    const failed = made(page, [move(2, 1)]);
    failed.error = { code: "program", message: "no" };
    accept(20, failed);
    assert.deepEqual(results.standing(ofFeed(20)), { is: "failed", run: failed, why: "no" });
    accept(10, two());
    assert.deepEqual(is(100, 50, 20, 10), ["dropped", "stopped", "failed", "done"]);
    accept(100, two());
    assert.deepEqual(is(100, 50, 20, 10), ["done", "dropped", "failed", "done"]);
    accept(70, Object.defineProperty(two(), "isLong", { value: true }));
    assert.deepEqual(is(100, 70), ["done", "dropped"], "a run that is too long for the page");
    documents.put("a.nc", "G1 X9\n");
    assert.deepEqual(results.standing(ofFeed(100)).files, ["a.nc"]);
    assert.deepEqual(is(100, 20, 10), ["earlier", "earlier", "earlier"]);
  },

  "a run is of earlier documents by what it reads, until they are again what they were": (page) => {
    const documents = new page.Documents(new Map([["m.toml", "[[axis]]\n"]]));
    documents.put("a.nc", source);
    documents.put("other.nc", "G1");
    const setup = { ...page.emptySetup(), program: "a.nc", machine: "m.toml" };
    const origin = page.createSnapshot(setup, documents);
    const run = made(page, [move(2, 1)]);
    const changed = () => page.changedSince(run, origin, documents);
    assert.deepEqual(changed(), []);
    documents.put("other.nc", "G1 X1");
    documents.put("my.variants.json", "{}");
    assert.deepEqual(changed(), []);
    documents.put("a.nc", "G1 X9\n");
    documents.put("m.toml", "[[axis]]\n# mine\n");
    assert.deepEqual(changed().sort(), ["a.nc", "m.toml"]);
    documents.put("a.nc", source);
    documents.remove("m.toml");
    assert.deepEqual(changed(), []);
  },

  "what the engine reads from the folder is another file by its version, whenever its text comes": (page) => {
    const documents = new page.Documents(new Map());
    const bytesOf = (text) => new TextEncoder().encode(text);
    documents.storeFolderFile("a.nc", bytesOf(source));
    const versions = (entries) => new Map(Object.entries({ "a.nc": "a1", "m.toml": "m1", "tool.toml": "t1", "large.nc": "l1", ...entries }));
    const setup = { ...page.emptySetup(), program: "a.nc", machine: "m.toml" };
    const origin = page.createSnapshot(setup, documents, versions());
    const run = made(page, [move(2, 1)], { "a.nc": source, "large.nc": "" });
    const changed = (entries) => page.changedSince(run, origin, documents, versions(entries));
    assert.deepEqual(changed(), []);
    assert.deepEqual(changed({ "large.nc": "l2" }), ["large.nc"], "of which the page never has a text");
    assert.deepEqual(changed({ "new.toml": "n1" }), ["new.toml"]);
    documents.storeFolderFile("tool.toml", bytesOf("a = 1\n"));
    documents.storeFolderFile("m.toml", bytesOf("[[axis]]\n"));
    assert.deepEqual(changed(), [], "for the first time");
    assert.deepEqual(changed({ "tool.toml": "t2" }), ["tool.toml"]);
    documents.put("tool.toml", "a = 2\n");
    assert.deepEqual(changed(), ["tool.toml"], "typed here");
    documents.put("tool.toml", "a = 1\n");
    assert.deepEqual(changed(), []);
    // The texts show if a document that the page has had has changed.
    assert.deepEqual(changed({ "a.nc": "a2" }), []);
    documents.storeFolderFile("a.nc", bytesOf("G1 X9\n"));
    assert.deepEqual(changed({ "a.nc": "a2" }), ["a.nc"]);
  },
};

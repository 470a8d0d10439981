// Path files: reading, changes of their text, walks through them, arcs, leads, round trips.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { near, segmentsMessage } from "./made.mjs";

export const modules = [
  ...["core/json_text", "run/segments", "run/path/path_file", "run/path/path_traversal", "run/path/path_edit", "run/path/path_arc"],
  ...["run/path/path_motion", "run/path/leads", "run/path/line_segment_tree", "run/path/round_trip"],
];

const sample = readFileSync(fileURLToPath(new URL("../../../samples/wheel.path.json", import.meta.url)), "utf8");

const part = (...targets) => `{
"name": "part",
"root": "part",
"paths": [
{"name": "part", "targets": [
${targets.map((each) => `  ${each}`).join(",\n")}
]}
]
}
`;
const at = (x, y, more = "") => `{"position_mm": [${x}, ${y}, 0]${more}}`;
const square = part(at(0, 0, ', "motion": "rapid"'), at(10, 0, ', "feed_mm_min": 100'), at(10, 10), at(0, 10), at(0, 0));
const place = (target, path = 0) => ({ path, target });

/** A file of a text that has to be one. */
function read({ readPathFile, isPathFile }, text) {
  const file = readPathFile(text);
  assert.ok(isPathFile(file), file.text);
  return file;
}
const walkOf = (page, text) => page.traversePath(read(page, text));
const responseDiagnostics = (page, text) => walkOf(page, text).errors.map(({ text: sentence }) => sentence);

/** The lines in which texts differ. */
function changedLines(before, after) {
  const [a, b] = [before.split("\n"), after.split("\n")];
  return { gone: a.filter((line) => !b.includes(line)), come: b.filter((line) => !a.includes(line)) };
}

export default {
  "what is no JSON is told with line and column": (page) => {
    const tell = (text) => page.readPathFile(text).text;
    assert.equal(tell('{"paths": [\n  {"name" "a"}]}'), "Line 2, column 11: ':' is expected here");
    assert.equal(tell('{"paths": [1,]}'), "Line 1, column 14: a value is expected here");
    assert.equal(tell('{"paths": [1 2]}'), "Line 1, column 14: ',' or ']' is expected here");
    assert.equal(tell('{"paths": ['), "Line 1, column 12: the text ends too early");
    assert.equal(tell("{} x"), "Line 1, column 4: nothing may follow the end");
    assert.equal(tell('{"a": "\n"}'), "Line 1, column 7: a value is expected here");
    assert.equal(tell("[".repeat(1000)), "Line 1, column 502: values are nested too deep");
    assert.deepEqual(page.readJson(' {"a": [-1.5e3, true, null, "\\u00e4\\n"]} '), { a: [-1500, true, null, "ä\n"] });
  },

  "what is no path file is told with its place": (page) => {
    const tell = (text) => page.readPathFile(text).text;
    assert.equal(tell("{}"), "Line 1, column 1: a path file needs 'paths' with at least one path");
    assert.match(tell('{"path": []}'), /unknown key 'path' in the path file; known keys: \$schema, format, name, root, paths/);
    assert.equal(tell('{"paths": [\n{"name": "a", "targets": []}]}'), "Line 2, column 1: the path 'a' has no targets");
    const point = (members) => page.readPathFile(part(`{"position_mm": [0, 0, 0], ${members}}`)).text;
    assert.equal(point('"feed_mm_min": 0'), "Line 6, column 3: 'feed_mm_min' must be a number greater than 0 and at most 1e9");
    assert.equal(point('"via_mm": [0, 0, 0]'), "Line 6, column 3: 'via_mm' is only for circular motions");
    assert.match(point('"motion": "circular"'), /needs either 'via_mm' or 'center_mm'/);
    assert.match(point('"rotary_deg": {"BC": 1}'), /'rotary_deg' must be an object such as/);
    assert.match(point('"tool_axis": [0, 0, 1], "rpy_deg": [0, 0, 0]'), /only one of 'tool_axis', 'rpy_deg' and 'rotary_deg'/);
    assert.match(point('"constructor": 1'), /unknown key 'constructor' in a point/);
    assert.match(tell(part('{"motion": "rapid"}')), /lacks the key 'position_mm'/);
    assert.match(tell(part('{"path": "a", "name": "b"}')), /unknown key 'name' in a sub-path; known keys: path, repeats/);
    assert.match(tell(part('{"path": "a", "repeats": 1.5}')), /'repeats' must be an integer/);
  },

  "fixed and reference points, work frames and tools are read, and stay where a form changes what is beside them": (page) => {
    const text =
      '{"paths": [{"name": "p", "work_offset": "G55", "set_offset_mm": [1, 2, 3], "probe_offset": [{"axis": "Z", "from_mm": [0, 0, 9], "to_mm": -1, "surface_mm": 0, "feed_mm_min": 60, "tool": 9}], "tool": 3, "length_offset": 0, "diameter_offset": 4, "targets": [' +
      '\n{"reference": 1},\n{"motion": "rapid", "position_mm": [0, 0, 5]},\n{"fixed": "CLAMP1", "name": "left", "dwell_s": 1, "actions": ["clamp"]},' +
      '\n{"path": "q", "work_offset": "G56", "set_offset_mm": [4, 5, 6]}]},\n{"name": "q", "targets": [{"fixed": 2}, {"motion": "rapid", "position_mm": [1, 1, 1]}]}]}';
    const file = read(page, text);
    const { motions, before, errors } = page.traversePath(file);
    assert.deepEqual(errors, []);
    assert.deepEqual(motions.map(({ from_mm, to_mm }) => [from_mm, to_mm]), [[null, [0, 0, 5]], [null, [1, 1, 1]]]);
    assert.equal(before.get("0/1").atMachinePoint, true);
    assert.equal(before.get("1/1").atMachinePoint, true);
    const changed = page.setTarget(text, place(1), { position_mm: [7, 8, 9] });
    assert.equal(changed, text.replace("[0, 0, 5]", "[7, 8, 9]"));
    assert.equal(page.setTarget(text, place(3), { repeats: 2 }), text.replace('"path": "q", "work', '"path": "q", "repeats": 2, "work'));
  },

  "what is wrong with fixed and reference points, frames and tools is told": (page) => {
    const tell = (targets, keys = "") => page.readPathFile(`{"paths": [{"name": "p"${keys}, "targets": [${targets}]}]}`).text;
    assert.match(tell('{"fixed": 1, "reference": 1}'), /are two points; a target may have only one of them/);
    assert.match(tell('{"fixed": "2nd"}'), /'fixed' must be the number of a fixed point, or its name/);
    assert.match(tell('{"fixed": 100000}'), /'fixed' must be/);
    assert.match(tell('{"reference": "DOCK"}, {"reference": "a-b"}'), /'reference' must be an integer from 1 to 4, or the name/);
    assert.match(tell('{"reference": 5}'), /'reference' must be an integer from 1 to 4/);
    assert.match(tell('{"reference": 1, "motion": "rapid"}'), /unknown key 'motion' in a fixed or reference point; known keys: name, fixed/);
    assert.match(tell('{"fixed": 1}', ', "tool": 1.5'), /'tool' must be an integer from 0/);
    assert.match(tell('{"fixed": 1}', ', "length_offset": 1'), /'length_offset' requires 'tool'/);
    assert.match(tell('{"fixed": 1}', ', "set_offset_mm": [1, 2, 3]'), /'set_offset_mm' requires 'work_offset'/);
    assert.match(tell('{"path": "q", "set_offset_mm": [1, 2, 3]}'), /'set_offset_mm' requires 'work_offset'/);
    const touch = (members) => tell('{"fixed": 1}', `, "work_offset": "G55", "probe_offset": [{${members}}]`);
    const way = '"from_mm": [0, 0, 9], "to_mm": -1, "surface_mm": 0, "feed_mm_min": 60';
    assert.match(touch(way), /'probe_offset' has a touch that lacks the key 'axis'/);
    assert.match(touch(`"axis": "B", ${way}`), /'probe_offset' has a touch in which 'axis' must be "X", "Y" or "Z"/);
    assert.match(touch(`"axis": "X", ${way}, "depth": 1`), /has a touch in which unknown key 'depth' in a touch; known keys: axis, from_mm/);
    assert.match(tell('{"fixed": 1}', ', "work_offset": "G55", "probe_offset": []'), /'probe_offset' must be a list of at least one touch/);
    assert.match(tell('{"fixed": 1}', `, "probe_offset": [{"axis": "X", ${way}}]`), /'probe_offset' requires 'work_offset'/);
    const line = '{"position_mm": [0, 0, 0], "feed_mm_min": 1}';
    for (const targets of [`{"fixed": 1}, ${line}`, `{"path": "p2"}, ${line}`]) {
      const text = `{"paths": [{"name": "p", "targets": [${targets}]}, {"name": "p2", "targets": [{"reference": 2}]}]}`;
      assert.deepEqual(responseDiagnostics(page, text), [
        "The first motion after a fixed or reference point must be a rapid, because the position of that point in the work is unknown.",
      ]);
    }
  },

  "values go into a text where they stand, and leave the rest": ({ setMember, replaceValue, insertItems, removeItems, reorderItems }) => {
    const text = '{ "a" : [1,  2,\n 3], "c":{"x": 1.50} }';
    assert.equal(replaceValue(text, ["a", 1], 7), '{ "a" : [1,  7,\n 3], "c":{"x": 1.50} }');
    assert.equal(setMember(text, [], "b", true, ["a", "b", "c"]), '{ "a" : [1,  2,\n 3], "b": true, "c":{"x": 1.50} }');
    assert.equal(setMember(text, ["c"], "x", undefined, []), '{ "a" : [1,  2,\n 3], "c":{} }');
    assert.equal(setMember('{"a": {}}', ["a"], "x", [1], []), '{"a": {"x": [1]}}');
    assert.equal(setMember('{"b": 1}', [], "a", 0, ["a", "b"]), '{"a": 0, "b": 1}');
    assert.equal(removeItems(text, ["a"], 0, 2), '{ "a" : [3], "c":{"x": 1.50} }');
    assert.equal(removeItems(text, ["a"], 2, 1), '{ "a" : [1,  2], "c":{"x": 1.50} }');
    assert.equal(insertItems("[]", [], 0, [1, 2]), "[1, 2]");
    assert.equal(insertItems("[1]", [], 1, [2]), "[1, 2]");
    assert.equal(insertItems("[\n  1,\n  2\n]", [], 0, [0]), "[\n  0,\n  1,\n  2\n]");
    assert.equal(reorderItems("[1,\n 22,  3]", [], [2, 0, 1]), "[3,\n 1,  22]");
    const pretty = JSON.stringify({ a: [{ x: [1, 2] }] }, null, 2);
    assert.equal(insertItems(pretty, ["a"], 1, [{ x: [3] }]), JSON.stringify({ a: [{ x: [1, 2] }, { x: [3] }] }, null, 2));
    assert.equal(replaceValue(pretty, ["a", 0, "x"], [5]), JSON.stringify({ a: [{ x: [5] }] }, null, 2));
  },

  "a change of a point touches its line alone": (page) => {
    const changed = page.setTarget(sample, place(1, 1), { feed_mm_min: 3000, via_mm: [284.2, 500, 52], rotary_deg: undefined, tool_axis: [0, 0, 1] });
    const { gone, come } = changedLines(sample, changed);
    assert.equal(gone.length, 1);
    const line = '  {"motion": "circular", "position_mm": [500, 715.9, 52], "via_mm": [284.2, 500, 52], "tool_axis": [0, 0, 1], "feed_mm_min": 3000},';
    assert.deepEqual(come, [line]);
    assert.equal(page.setTarget(changed, place(0, 0), { repeats: 3 }).includes('{"path": "rim", "repeats": 3}'), true);
  },

  "points are added, copied, moved and taken out": (page) => {
    const file = read(page, square);
    const positions = (text) => read(page, text).paths[0].targets.map(({ position_mm }) => position_mm.slice(0, 2).join());
    const added = page.addTargets(square, file, place(1), [{ motion: "linear", position_mm: [1, 2, 3] }]);
    assert.deepEqual(changedLines(square, added), { gone: [], come: ['  {"motion": "linear", "position_mm": [1, 2, 3]},'] });
    assert.deepEqual(positions(added), ["0,0", "10,0", "1,2", "10,10", "0,10", "0,0"]);
    assert.deepEqual(positions(page.addTargets(square, file, place(-1), [{ position_mm: [5, 5, 0] }])).at(-1), "5,5");
    assert.deepEqual(positions(page.duplicateTargets(square, place(1), 2)), ["0,0", "10,0", "10,10", "10,0", "10,10", "0,10", "0,0"]);
    assert.deepEqual(positions(page.moveTargets(square, file, place(1), 2, 2)), ["0,0", "0,10", "10,0", "10,10", "0,0"]);
    assert.equal(page.moveTargets(square, file, place(1), 2, 1), square);
    assert.deepEqual(positions(page.removeTargets(square, file, place(3), 2)), ["0,0", "10,0", "10,10"]);
    assert.equal(page.removeTargets(square, file, place(0), 5), square, "a path keeps one");
  },

  "some points become a sub-path, which is renamed, made the root and taken out": (page) => {
    const made = page.makeSubPath(square, read(page, square), place(1), 3, "edge");
    let file = read(page, made);
    assert.deepEqual(file.paths[0].targets[1], { path: "edge" });
    assert.deepEqual([file.paths[0].targets.length, file.paths[1].targets.length], [3, 3]);
    assert.deepEqual(walkOf(page, made).motions.map(({ to_mm }) => to_mm), walkOf(page, square).motions.map(({ to_mm }) => to_mm));
    assert.equal(page.freeName(file, "edge"), "edge 2");
    assert.equal(page.removePath(made, file, 1), made, "it is used");
    const renamed = page.renamePath(page.setRoot(made, "edge"), file, 1, "side");
    file = read(page, renamed);
    assert.deepEqual([file.paths[1].name, file.paths[0].targets[1].path, file.root], ["side", "side", "edge"]);
    const asRoot = page.renamePath(made, read(page, made), 0, "whole");
    assert.deepEqual([read(page, asRoot).root, read(page, asRoot).paths[0].name], ["whole", "whole"]);
    const free = page.setTarget(page.setRoot(renamed, "part"), place(1), { path: "part" });
    assert.equal(read(page, page.removePath(free, read(page, free), 1)).paths.length, 1);
  },

  "points take over what those before them say, through sub-paths": (page) => {
    const { before, used, motions } = walkOf(page, sample);
    assert.deepEqual([...used].sort(), [0, 1, 2, 3]);
    const state = before.get("1/2");
    assert.equal(state.feed_mm_min, 6350);
    assert.deepEqual(state.rotary_deg, { B: -180, C: 0 });
    const intoPockets = motions.find(({ place: { path, target } }) => path === 2 && target === 0);
    assert.deepEqual([intoPockets.from_mm, intoPockets.after], [[500, 284.1, 52], place(3, 1)]);
    const text = '{"paths": [{"name": "a", "targets": [{"position_mm": [0, 0, 0], "feed_mm_min": 5, "feed_mm_rev": 1}, {"path": "b", "repeats": 3}, {"position_mm": [9, 0, 0]}]}, {"name": "b", "targets": [{"position_mm": [1, 0, 0], "tool_axis": [1, 0, 0]}, {"position_mm": [2, 0, 0], "feed_mm_min": 6}]}, {"name": "c", "targets": [{"position_mm": [3, 0, 0]}]}]}';
    const walk = walkOf(page, text);
    const { feed_mm_min, feed_mm_rev, tool_axis } = walk.before.get("0/2");
    assert.deepEqual([feed_mm_min, feed_mm_rev, tool_axis], [6, undefined, [1, 0, 0]]);
    const ways = walk.motions.filter(({ place: { path } }) => path === 1).map(({ from_mm, to_mm }) => `${from_mm[0]} ${to_mm[0]}`);
    assert.deepEqual(ways, ["0 1", "1 2", "2 1"]);
    assert.deepEqual([...walk.used], [1, 0]);
  },

  "what is wrong between points is told with its place": (page) => {
    const wrong = (...targets) => responseDiagnostics(page, part(...targets));
    assert.match(wrong(at(0, 0, ', "motion": "circular", "via_mm": [1, 1, 0]'))[0], /its start is unknown/);
    assert.match(wrong(at(0, 0), at(9, 0, ', "motion": "circular", "via_mm": [4, 0, 0]'))[0], /on the line through start and end/);
    assert.match(wrong(at(0, 0), at(0, 0, ', "motion": "circular", "via_mm": [4, 0, 0]'))[0], /must not end at its start/);
    assert.match(wrong(at(0, 0), at(9, 0, ', "motion": "circular", "center_mm": [4, 0, 0], "turn_deg": 180'))[0], /starts 4\.00000 mm .* ends 5\.00000 mm/);
    assert.match(wrong(at(0, 0), at(8, 0, ', "motion": "circular", "center_mm": [4, 0, 0], "turn_deg": 90'))[0], /90° does not reach the end; 180\.000°/);
    assert.match(wrong('{"path": "nowhere"}', at(0, 0))[0], /No path has the name 'nowhere'/);
    assert.match(wrong(at(0, 0), '{"path": "part"}')[0], /'part' contains itself/);
    const chain = Array.from({ length: 11 }, (_, i) => `{"name": "p${i}", "targets": [${i < 10 ? `{"path": "p${i + 1}"}` : at(0, 0)}]}`);
    assert.match(responseDiagnostics(page, `{"paths": [${chain.join()}]}`)[0], /deeper than 8 levels/);
    assert.match(responseDiagnostics(page, `{"root": "x", "paths": [${chain[10]}, ${chain[10]}]}`).join(), /Two paths have the name 'p10'.*No path has the name 'x'/);
  },

  "paths that are used very often are gone through once": (page) => {
    const levels = Array.from({ length: 8 }, (_, i) => {
      const uses = Array.from({ length: 300 }, () => (i < 7 ? `{"path": "p${i + 1}", "repeats": 9}` : at(1, 1)));
      return `{"name": "p${i}", "targets": [${at(i, 0)}, ${uses.join()}]}`;
    });
    const began = performance.now();
    const { motions, errors } = walkOf(page, `{"paths": [${levels.join()}]}`);
    assert.deepEqual(errors, []);
    assert.ok(motions.length < 5000 && performance.now() - began < 2000, `${motions.length} motions`);
  },

  "arcs go through their via points, round their centres, and rise": ({ arcTo, arcPoint, sampleArc, arcDirection }) => {
    const via = arcTo([10, 0, 5], { position_mm: [-10, 0, 5], via_mm: [0, -10, 5] });
    arcPoint(via, 0.5).forEach((value, i) => near(value, [0, -10, 5][i]));
    near(via.turn_rad, Math.PI);
    arcDirection(via, 0).forEach((value, i) => near(value, [0, -1, 0][i]));
    const helix = arcTo([10, 0, 0], { position_mm: [10, 0, 6], center_mm: [0, 0, 0], turn_deg: 720 });
    arcPoint(helix, 0.25).forEach((value, i) => near(value, [-10, 0, 1.5][i]));
    const clockwise = arcTo([10, 0, 0], { position_mm: [0, 10, 0], center_mm: [0, 0, 0], normal: [0, 0, -2], turn_deg: 270 });
    arcPoint(clockwise, 1 / 3).forEach((value, i) => near(value, [0, -10, 0][i]));
    const points = [[10, 0, 5], ...sampleArc(via, 0.01)];
    for (let i = 1; i < points.length; ++i) {
      const middle = points[i].map((value, k) => (value + points[i - 1][k]) / 2);
      assert.ok(10 - Math.hypot(middle[0], middle[1]) <= 0.01);
    }
  },

  "an arc is said by its centre and by its via point": (page) => {
    const text = part(at(10, 0), '{"motion": "circular", "position_mm": [-10, 0, 0], "via_mm": [0, 10, 0]}');
    const point = read(page, text).paths[0].targets[1];
    const byCenter = page.convertArc(point, [10, 0, 0], "center");
    assert.deepEqual(byCenter, { via_mm: undefined, center_mm: [0, 0, 0], normal: [0, 0, 1], turn_deg: 180 });
    const changed = page.setTarget(text, place(1), byCenter);
    assert.deepEqual(responseDiagnostics(page, changed), []);
    const back = page.convertArc(read(page, changed).paths[0].targets[1], [10, 0, 0], "via");
    assert.deepEqual(back.via_mm, [0, 10, 0]);
    const circle = { position_mm: [10, 0, 0], center_mm: [0, 0, 0], turn_deg: 360 };
    assert.equal(page.convertArc(circle, [10, 0, 0], "via"), null, "a full circle has no via point");
  },

  "another motion brings what it needs, and takes along what it does not": (page) => {
    const toArc = page.motionChange({ position_mm: [10, 0, 0] }, "circular", [0, 0, 0], [0, 0, 1]);
    const text = page.setTarget(part(at(0, 0), at(10, 0)), place(1), toArc);
    assert.deepEqual(responseDiagnostics(page, text), []);
    const back = page.motionChange(read(page, text).paths[0].targets[1], "rapid", [0, 0, 0], [0, 0, 1]);
    assert.match(page.setTarget(text, place(1), back), /\{"motion": "rapid", "position_mm": \[10, 0, 0\]\}/);
  },

  "a point that moves takes arcs along that fit no longer": (page) => {
    const arc = ', "motion": "circular", "center_mm": [5, 0, 0], "normal": [0, 0, -1], "turn_deg": 180';
    const text = part(at(0, 0), at(10, 0, arc), at(20, 0));
    const move = (target, to) => page.movePoint(text, read(page, text), walkOf(page, text), place(target), to);
    for (const [target, to] of [[0, [0, -1, 0]], [1, [11, 0, 2.0000004]]]) {
      const moved = move(target, to);
      const { via_mm, center_mm } = read(page, moved).paths[0].targets[1];
      assert.deepEqual([via_mm, center_mm], [[5, 5, 0], undefined]);
      assert.deepEqual(responseDiagnostics(page, moved), []);
    }
    assert.deepEqual(read(page, move(1, [11, 0, 2.0000004])).paths[0].targets[1].position_mm, [11, 0, 2]);
    assert.deepEqual(changedLines(text, move(2, [20, 1, 0])).gone.length, 1);
  },

  "a lead runs in along the tangent, and takes pierce and jet along": (page) => {
    const cut = part(
      '{"motion": "rapid", "position_mm": [0, 0, 25], "tool_axis": [0, 0, 1]}',
      '{"motion": "rapid", "position_mm": [0, 0, 3], "actions": ["waterjet_on"]}',
      '{"position_mm": [0, 0, 3], "feed_mm_min": 100, "dwell_s": 2}',
      '{"position_mm": [50, 0, 3], "feed_mm_min": 80}',
      '{"position_mm": [50, 40, 3], "actions": ["waterjet_off"], "dwell_s": 1}',
      '{"motion": "rapid", "position_mm": [50, 40, 25]}',
    );
    const choice = { kind: "arc", size_mm: 4, angle_deg: 90, side: "right", into: true, out: true };
    const text = page.addLeads(cut, read(page, cut), walkOf(page, cut), place(0), 6, choice);
    const { targets } = read(page, text).paths[0];
    assert.deepEqual(targets.slice(0, 3).map(({ position_mm }) => position_mm), [[-4, -4, 25], [-4, -4, 3], [-4, -4, 3]]);
    assert.deepEqual(targets[3], { motion: "circular", position_mm: [0, 0, 3], center_mm: [0, -4, 3], normal: [0, 0, -1], turn_deg: 90, feed_mm_min: 80 });
    assert.deepEqual(targets[5], { position_mm: [50, 40, 3] });
    assert.deepEqual(targets[6].position_mm, [54, 44, 3]);
    assert.deepEqual([targets[6].actions, targets[6].dwell_s], [["waterjet_off"], 1]);
    assert.deepEqual(targets[7].position_mm, [54, 44, 25]);
    assert.deepEqual(responseDiagnostics(page, text), []);
    const line = page.addLeads(cut, read(page, cut), walkOf(page, cut), place(0), 6, { ...choice, kind: "line", angle_deg: 90, side: "left", out: false });
    assert.deepEqual(read(page, line).paths[0].targets[2].position_mm, [0, 4, 3]);
    assert.equal(read(page, line).paths[0].targets.length, 7);
    assert.match(page.addLeads(cut, read(page, cut), walkOf(page, cut), place(0), 2, choice).error, /no cut/);
  },

  "the nearest of many pieces is found": ({ LineSegmentTree }) => {
    let seed = 7;
    const random = () => (seed = (seed * 48271) % 2147483647) / 2147483647;
    const ends = Float64Array.from({ length: 6 * 333 }, () => 100 * random());
    const all = new LineSegmentTree(ends);
    for (let n = 0; n < 200; ++n) {
      const at = [0, 1, 2].map(() => 140 * random() - 20);
      let least = Infinity;
      for (let i = 0; i < 333; ++i) least = Math.min(least, new LineSegmentTree(ends.subarray(6 * i, 6 * i + 6)).distanceTo(...at));
      near(all.distanceTo(...at), least, 1e-12);
    }
    assert.equal(new LineSegmentTree(new Float64Array(0)).distanceTo(0, 0, 0), Infinity);
  },

  "a round trip finds what a run leaves out, and where it goes elsewhere": (page) => {
    const ran = (vertices, approach = 0) => {
      const segments = new page.Segments(2, [0, 1]);
      const message = segmentsMessage(vertices.slice(1).map((_, i) => ({ line: i + 1, duration_s: 1, kind: i === 0 ? approach : 1 })));
      message.columns.set("vertex_mm", Float32Array.from(vertices.flat()));
      message.columns.set("vertex_s", Float32Array.from(vertices, (_, i) => i));
      message.columns.set("vertex_segment", Uint32Array.from(vertices, (_, i) => Math.max(i - 1, 0)));
      segments.add(message);
      return page.roundTrip(walkOf(page, square), segments);
    };
    const way = [[-50, -50, 0], [0, 0, 0], [10, 0, 0], [10, 10, 0], [0, 10, 0], [0, 0, 0]];
    assert.deepEqual(ran(way), { runDeviation_mm: 0, pathDeviation_mm: 0 });
    assert.deepEqual(ran(way, 1), { runDeviation_mm: 0, pathDeviation_mm: 0 }, "the way there is the machine's own, at feed, too");
    assert.ok(ran(way.map(([x, y]) => [x + 300, y, 0])).runDeviation_mm > 290, "a run elsewhere");
    near(ran(way.slice(0, 4)).pathDeviation_mm, 10);
    const bent = ran([...way.slice(0, 3), [15, 5, 0], ...way.slice(3)]);
    near(bent.runDeviation_mm, 5);
    assert.ok(bent.pathDeviation_mm > 3);
  },
};

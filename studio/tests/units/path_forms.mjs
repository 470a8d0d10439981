// Changes by path forms other than points: machine points, work frames, tools.

import assert from "node:assert/strict";

export const modules = ["run/path/path_file", "run/path/path_edit", "run/path/machine_points", "run/path/target_checks"];

const known = {
  fixed: [{ number: 1, name: "CLAMP1" }, { number: 7, name: "" }],
  reference: [{ number: 2, name: "DOCK" }, { number: 3, name: "" }],
};
const job = '{"paths": [\n{"name": "job", "targets": [\n  {"reference": 1},\n  {"path": "part"}\n]},\n{"name": "part", "targets": [{"motion": "rapid", "position_mm": [0, 0, 5]}]}]}';
const place = (target, path = 0) => ({ path, target });
const lineOf = (text, part) => text.split("\n").find((line) => line.includes(part));

export default {
  "machine points that data have are offered by their names, else by their numbers": ({ availablePoints, findPoint, parsePointId }) => {
    const [fixed, reference] = ["fixed", "reference"].map((kind) => availablePoints(kind, known));
    assert.deepEqual(fixed.map(({ value }) => value), ["CLAMP1", 7]);
    assert.deepEqual(reference.map(({ value, isHome }) => [value, isHome]), [[1, true], [2, true], [3, true], [4, true], ["DOCK", false]]);
    const meant = (kind, ident) => findPoint(ident, kind === "fixed" ? fixed : reference, kind)?.value;
    assert.deepEqual([meant("fixed", "clamp1"), meant("fixed", 1), meant("fixed", 7), meant("fixed", 2)], ["CLAMP1", "CLAMP1", 7, undefined]);
    assert.equal(meant("fixed", "7"), 7);
    // The numbers of homes are not those of section REFERENCE.
    assert.deepEqual([meant("reference", 2), meant("reference", "Dock"), meant("reference", "CLAMP1")], [2, "DOCK", undefined]);
    assert.deepEqual([parsePointId("7"), parsePointId("CLAMP1"), parsePointId("2nd"), parsePointId("-1")], [7, "CLAMP1", "2nd", "-1"]);
  },

  "a machine point is one that there is, and becomes one of the other kind": (page) => {
    const { firstMachinePoint, firstPointOfKind, noPoints, setTarget } = page;
    assert.deepEqual([firstMachinePoint(known), firstMachinePoint(noPoints)], [{ fixed: "CLAMP1" }, { reference: 1 }]);
    const fixed = setTarget(job, place(0), firstPointOfKind("fixed", known));
    assert.equal(lineOf(fixed, "fixed"), '  {"fixed": "CLAMP1"},');
    const more = setTarget(setTarget(fixed, place(0), { actions: ["clamp"] }), place(0), { dwell_s: 2, name: "left" });
    assert.equal(lineOf(more, "fixed"), '  {"name": "left", "fixed": "CLAMP1", "dwell_s": 2, "actions": ["clamp"]},');
    const back = setTarget(more, place(0), firstPointOfKind("reference", known));
    assert.equal(lineOf(back, "reference"), '  {"name": "left", "reference": 1, "dwell_s": 2, "actions": ["clamp"]},');
    assert.ok(page.isPathFile(page.readPathFile(back)));
  },

  "a path says its frame and its tool where files have them, and takes them away again": ({ setPath, setupValuesError }) => {
    const framed = setPath(job, 0, { work_offset: "G55" });
    assert.equal(lineOf(framed, '"job"'), '{"name": "job", "work_offset": "G55", "targets": [');
    const all = setPath(setPath(setPath(framed, 0, { tool: 3 }), 0, { length_offset: 0 }), 0, { set_offset_mm: [1, 2, 3] });
    assert.equal(lineOf(all, '"job"'), '{"name": "job", "work_offset": "G55", "set_offset_mm": [1, 2, 3], "tool": 3, "length_offset": 0, "targets": [');
    assert.equal(setPath(all, 0, { work_offset: undefined, set_offset_mm: undefined, tool: undefined, length_offset: undefined }), job);
    assert.equal(setupValuesError({ work_offset: "G55", set_offset_mm: undefined, tool: undefined }), null);
    assert.match(setupValuesError({ work_offset: undefined, set_offset_mm: [1, 2, 3] }), /'set_offset_mm' requires 'work_offset'/);
  },

  "the use of a sub-path says its frame behind how often it is used": ({ setTarget }) => {
    const framed = setTarget(job, place(1), { work_offset: "G56" });
    const often = setTarget(setTarget(framed, place(1), { set_offset_mm: [4, 5, 6] }), place(1), { repeats: 2 });
    assert.equal(lineOf(often, '"path"'), '  {"path": "part", "repeats": 2, "work_offset": "G56", "set_offset_mm": [4, 5, 6]}');
    assert.equal(setTarget(often, place(1), { repeats: undefined, work_offset: undefined, set_offset_mm: undefined }), job);
  },

  "a recorded path is one that says where its work offsets were": ({ isRecorded }) => {
    assert.deepEqual([{}, { work_offsets: {} }, { work_offsets: { 54: {} } }].map((file) => isRecorded({ paths: [], ...file })), [false, false, true]);
  },
};

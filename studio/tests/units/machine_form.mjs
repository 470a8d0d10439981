// Functions of the machine and cell forms that need no page: names of files in files, numbers with units,
// frames, dependencies.

import assert from "node:assert/strict";

const form = ["file/file_names", "form/quantity", "form/key_schema", "items/pose", "items/shape", "items/tree"].map((name) => `panels/machine/${name}`);
export const modules = [...form, "run/body_distance", "core/response_diagnostics", "core/references", "three"];

const near = (a, b, within = 1e-6) => assert.ok(Math.abs(a - b) <= within, `${a} is not ${b}`);

/** Applies changes to a value, as the engine does to a text. */
function applied(value, changes) {
  const copy = structuredClone(value);
  for (const { op, at, value: expectedValue } of changes) {
    const last = at.at(-1);
    let table = copy;
    for (const step of at.slice(0, -1)) table = table[step] ??= {};
    if (op === "set") table[last] = expectedValue;
    else if (Array.isArray(table)) table.splice(last, 1);
    else delete table[last];
  }
  return copy;
}

const cell = {
  ignore: [
    ["jet", "slats"],
    ["jet", "table"],
  ],
  cell: { machine: "../machines/af5.toml" },
  frame: [{ name: "corner", frame: { x_mm: 100 } }],
  object: [
    { name: "table", frame: { x_mm: 10, roll_deg: 90 } },
    { name: "slats", attached_to: "table", frame: { x_mm: 5, z_mm: 50 } },
    { name: "mould", shape: { mesh: "mould.stl" } },
  ],
};

export default {
  "names in a file count from its folder": ({ resolved, referenceTo }) => {
    assert.equal(resolved("samples/cell/table.toml", "../machines/af5.toml"), "samples/machines/af5.toml");
    assert.equal(resolved("table.toml", "mould.stl"), "mould.stl");
    assert.equal(resolved("a/b.toml", "./c//d.stl"), "a/c/d.stl");
    for (const [file, document] of [
      ["samples/cell/table.toml", "samples/machines/af5.toml"],
      ["table.toml", "samples/cell/mould.stl"],
      ["a/b/c.toml", "d.stl"],
      ["a/b/c.toml", "a/b/d.stl"],
    ]) {
      assert.equal(resolved(file, referenceTo(file, document)), document);
    }
    assert.equal(referenceTo("my.toml", "samples/cell/mould.stl"), "samples/cell/mould.stl");
  },

  "a copy elsewhere names the same files": ({ moved, resolved, copyName }) => {
    const copy = applied(cell, moved(cell, "samples/cell/table.toml", "my-table.toml"));
    assert.equal(resolved("my-table.toml", copy.cell.machine), "samples/machines/af5.toml");
    assert.equal(resolved("my-table.toml", copy.object[2].shape.mesh), "samples/cell/mould.stl");
    assert.deepEqual(moved(cell, "samples/cell/table.toml", "samples/cell/other.toml"), []);
    const taken = new Set(["my-table.toml", "my-table-2.toml"]);
    assert.equal(copyName("samples/cell/table.toml", (name) => taken.has(name)), "my-table-3.toml");
    assert.equal(copyName("my-router3.toml", () => false), "my-router3.toml");
  },

  "a controller that is built in is no file": ({ moved }) => {
    const changes = (model) => moved({ controller: { model } }, "samples/machines/a.toml", "my-a.toml");
    assert.deepEqual(changes("grbl-1.1"), []);
    assert.deepEqual(changes("own.toml"), [{ op: "set", at: ["controller", "model"], value: "samples/machines/own.toml" }]);
  },

  "names of keys tell their unit": ({ keyUnit, keyLabel, unitText }) => {
    assert.deepEqual(["max_speed_mm_s", "position_gain_1_s", "min_deg", "min_feed_mm_min", "limit_jerk", "standstill_s"].map(keyUnit), ["mm/s", "1/s", "deg", "mm/min", "", "s"]);
    assert.deepEqual(["max_acceleration_mm_s2", "home2_mm", "limit_jerk", "a_mm"].map(keyLabel), ["Max acceleration", "Home 2", "Limit jerk", "A"]);
    assert.deepEqual([unitText("mm/s2", "mm"), unitText("mm/s2", "inch"), unitText("deg/s", "inch"), unitText("percent", "mm")], ["mm/s²", "in/s²", "°/s", "%"]);
  },

  "a key is changed by the name that the file has": ({ nameIn }) => {
    assert.equal(nameIn({ rest_s: 1 }, "standstill_s", "rest_s"), "rest_s");
    assert.equal(nameIn({ standstill_s: 1 }, "standstill_s", "rest_s"), "standstill_s");
    assert.equal(nameIn({}, "standstill_s", "rest_s"), "standstill_s");
    assert.equal(nameIn({ settle_s: 1 }, "settle_s"), "settle_s");
  },

  "numbers are mm in files, mm or inch on the page": ({ numberText, parseNumber }) => {
    assert.equal(numberText(254, "mm/s", "inch"), "10");
    assert.equal(numberText(254, "deg/s", "inch"), "254");
    assert.equal(numberText("inf", "mm", "mm"), "inf");
    assert.equal(parseNumber("10", "mm/s", "inch"), 254);
    assert.equal(parseNumber(" -3.5 ", "mm", "mm"), -3.5);
    assert.equal(parseNumber("−3", "deg", "mm"), -3);
    assert.equal(parseNumber("inf", "mm", "inch"), "inf");
    for (const text of ["", "12,5", "1e999", "ten", "5 mm"]) assert.equal(parseNumber(text, "mm", "mm"), null, text);
  },

  "a frame's numbers and its matrix are the same": ({ poseMatrix, toPose, poseChanges }) => {
    const pose = { x_mm: 1, y_mm: -2, z_mm: 3, roll_deg: 30, pitch_deg: -40, yaw_deg: 50 };
    assert.deepEqual(toPose(poseMatrix(pose), 6), pose);
    // Rz(90) rotates X to Y.
    const { elements } = poseMatrix({ roll_deg: 90 });
    near(elements[0], 0);
    near(elements[1], 1);
    // Yaw about X: Y to Z.
    near(poseMatrix({ yaw_deg: 90 }).elements[6], 1);
    assert.deepEqual(poseChanges(["object", 0, "frame"], { x_mm: 1 }, { ...pose, yaw_deg: 0 }), [
      { op: "set", at: ["object", 0, "frame", "y_mm"], value: -2 },
      { op: "set", at: ["object", 0, "frame", "z_mm"], value: 3 },
      { op: "set", at: ["object", 0, "frame", "roll_deg"], value: 30 },
      { op: "set", at: ["object", 0, "frame", "pitch_deg"], value: -40 },
    ]);
  },

  "what was attached to an object that goes stays where it is": ({ removeChanges, poseMatrix, Matrix4 }) => {
    const place = (of, name) => {
      const { frame = {}, attached_to } = of.object.find((each) => each.name === name);
      return attached_to && attached_to !== "world" ? new Matrix4().multiplyMatrices(place(of, attached_to), poseMatrix(frame)) : poseMatrix(frame);
    };
    const after = applied(cell, removeChanges(cell, "object", 0));
    assert.deepEqual(after.object.map(({ name }) => name), ["slats", "mould"]);
    place(after, "slats").elements.forEach((value, i) => near(value, place(cell, "slats").elements[i]));
    assert.deepEqual(after.ignore, [["jet", "slats"]]);
  },

  "a new name is one wherever the old one stood": ({ renameChanges }) => {
    const after = applied(cell, renameChanges(cell, ["object", 0], "table", "bench"));
    assert.equal(after.object[0].name, "bench");
    assert.equal(after.object[1].attached_to, "bench");
    assert.deepEqual(after.ignore, [["jet", "slats"], ["jet", "bench"]]);
  },

  "names are free, shapes about as large": ({ freeItemName, convertShape, shapeKind, shapeDimensions }) => {
    assert.equal(freeItemName("box", (name) => ["box", "box 2"].includes(name)), "box 3");
    assert.equal(freeItemName("box 2", (name) => ["box", "box 2"].includes(name)), "box 3");
    assert.deepEqual(convertShape("cylinder", { box_mm: [60, 40, 20] }, ""), { cylinder_mm: [60, 20] });
    assert.deepEqual(convertShape("box", { cylinder_mm: [60, 20] }, ""), { box_mm: [60, 60, 20] });
    assert.deepEqual(convertShape("sphere", { mesh: "a.stl" }, ""), { sphere_mm: 100 });
    assert.deepEqual(convertShape("mesh", { sphere_mm: 5 }, "a.stl"), { mesh: "a.stl" });
    assert.equal(shapeKind({}), null);
    assert.deepEqual(shapeDimensions({ sphere_mm: 7 }), [7]);
  },

  "the gap between bodies is that of geometry": ({ createCore, distanceBetween, Matrix4 }) => {
    const at = (x, y, z) => new Matrix4().makeTranslation(x, y, z);
    const box = { kind: "box", half_mm: [10, 20, 30], margin_mm: 0 };
    const ball = { kind: "points", points_mm: [[0, 0, 0]], margin_mm: 5 };
    const rod = { kind: "cylinder", radius_mm: 4, half_height_mm: 50, margin_mm: 0 };
    const gap = (a, placeA, b, placeB) => distanceBetween(createCore(a, [], placeA), createCore(b, [], placeB));
    near(gap(box, at(0, 0, 0), box, at(50, 0, 0)), 30);
    near(gap(box, at(0, 0, 0), box, at(23, 44, 0)), 5);
    near(gap(box, at(0, 0, 0), ball, at(13, 24, 0)), 0);
    near(gap(box, at(0, 0, 0), ball, at(19, 32, 0)), 10);
    near(gap(box, at(0, 0, 0), ball, at(22, 24, 33)), Math.hypot(12, 4, 3) - 5);
    // Two crossed rods: the axes are 20 apart.
    const across = new Matrix4().makeRotationX(Math.PI / 2).setPosition(20, 0, 0);
    near(gap(rod, at(0, 0, 0), rod, across), 12, 1e-4);
    near(gap(rod, at(0, 0, 0), rod, at(0, 0, 107)), 7);
    near(gap(box, at(0, 0, 0), box, at(15, 10, 5)), 0);
  },

  "random balls and boxes are as far as the formula says": ({ createCore, distanceBetween, Matrix4, Vector3, Quaternion }) => {
    let seed = 7;
    const random = () => ((seed = (seed * 16807) % 2147483647) / 2147483647) * 2 - 1;
    for (let i = 0; i < 300; ++i) {
      const half = [5 + 4 * random(), 8 + 5 * random(), 3 + 2 * random()];
      const turn = new Quaternion(random(), random(), random(), random()).normalize();
      const place = new Matrix4().compose(new Vector3(20 * random(), 20 * random(), 20 * random()), turn, new Vector3(1, 1, 1));
      const centre = new Vector3(40 * random(), 40 * random(), 40 * random());
      const local = centre.clone().applyMatrix4(place.clone().invert()).toArray();
      const outside = Math.hypot(...local.map((value, k) => Math.max(0, Math.abs(value) - half[k])));
      const box = createCore({ kind: "box", half_mm: half, margin_mm: 0 }, [], place);
      const ball = createCore({ kind: "points", points_mm: [centre.toArray()], margin_mm: 2 }, [], new Matrix4());
      near(distanceBetween(box, ball), Math.max(0, outside - 2), 1e-4);
    }
  },

  "a failure's place is read off its sentence, and said once": ({ responseDiagnostics }) => {
    const failed = { ok: false, code: "input_file", message: "a/my.toml:12:3: unknown key 'x'" };
    const [error] = responseDiagnostics({ ...failed, messages: [] });
    assert.deepEqual([error.file, error.line, error.column, error.text], ["a/my.toml", 12, 3, "unknown key 'x'"]);
    const told = { severity: "error", code: "input_file", file: "a/my.toml", line: 12, column: 3, end_column: 0, text: "unknown key 'x'", hint: "" };
    assert.deepEqual(responseDiagnostics({ ...failed, messages: [{ is: "diagnostic", header: told }] }), [told]);
    assert.equal(responseDiagnostics({ ok: false, code: "usage", message: "no place", messages: [] })[0].line, 0);
    assert.deepEqual(responseDiagnostics({ ok: true, code: "", message: "", messages: [] }), []);
  },
};

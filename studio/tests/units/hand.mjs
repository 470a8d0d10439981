// Manual motion: grips of a handle on the screen, directions of the tool, moved joints.

import assert from "node:assert/strict";
import { near, runOf, scene } from "./made.mjs";

export const modules = [
  ...["run/run", "run/chain", "run/path/tool_direction", "run/path/rotary_solver", "run/path/rotate_orientation", "view/camera", "view/path_editing/handle_grips"],
  ...["core/store", "core/path_editing", "panels/teach/jog_state", "panels/paths/target_selection", "panels/paths/tree_rows", "three"],
];

const identity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
// Frames that rotate Z to the world's X, and back.
const zToX = [0, 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 0, 0, 1];
const xToZ = [0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 1];
const axis = (letter, rotary, more = {}) => ({
  ...{ letter, rotary, min: null, max: null, max_speed: null, max_acceleration: null, max_jerk: null, home: 0, zero: 0, carries: "tool" },
  ...more,
});

/** Returns a fork head: Z moves up, C turns about it, A tilts about X. */
const head = () =>
  scene({
    axes: [axis("Z", false, { min: -10, max: 200 }), axis("C", true, { min: -360, max: 360 }), axis("A", true, { min: -120, max: 120, zero: 5 })],
    tool_side: {
      base: identity,
      links: [
        { joint: 0, rotary: false, before: identity, after: identity },
        { joint: 1, rotary: true, before: identity, after: identity },
        { joint: 2, rotary: true, before: zToX, after: xToZ },
      ],
      end: identity,
    },
    tcps_mm: [[0, 0, -30]],
  });

const turn = ({ Quaternion, Vector3 }, about, degrees) =>
  new Quaternion().setFromAxisAngle(new Vector3(...about), (degrees * Math.PI) / 180);

/** An eye at a corner, above a point of the work. */
function standOf({ CameraRig, Matrix4, Vector3 }, name = "iso") {
  const rig = new CameraRig();
  rig.resize(800, 600);
  rig.setStandardView(name);
  rig.target.set(100, 50, 10);
  rig.apply();
  return { work: new Matrix4(), at: new Vector3(100, 50, 10), rig, width_px: 800, height_px: 600 };
}
const seen = ({ rig, at }, shift) => {
  const { x, y } = rig.project(at.clone().add(shift));
  return [x, y];
};

export default {
  "a tool stands as a direction, as angles or as rotary axes say": ({ Chain, toolDirection }) => {
    const chain = new Chain(head());
    const stands = (orientation, expected) => toolDirection(orientation, chain).toArray().forEach((value, i) => near(value, expected[i], 1e-9));
    stands({ tool_axis: [0, 0, 5] }, [0, 0, 1]);
    stands({ rpy_deg: [90, 90, 0] }, [0, 1, 0]);
    stands({ rotary_deg: { C: 0, A: 95 } }, [0, -1, 0]);
    stands({ rotary_deg: { C: 90, A: 95 } }, [1, 0, 0]);
    assert.equal(toolDirection({}, chain), null);
    assert.equal(toolDirection({ rotary_deg: { A: 0 } }, null), null);
  },

  "angles come back from the rotation that they make": ({ toQuaternion, toRpy }) => {
    for (const rpy of [[10, 20, 30], [-170, 80, 5], [0, 0, 0], [45, -60, 120]]) {
      toRpy(toQuaternion(rpy)).forEach((value, i) => near(value, rpy[i], 1e-6));
    }
  },

  "rotary axes are found for directions, near to where they are": (page) => {
    const chain = new page.Chain(head());
    for (const expectedValue of [[0.3, 0.2, 0.9], [1, 0, 0], [0, 0, 1], [-0.5, 0.5, 0.1], [0, -1, 0.01]]) {
      for (const start of [{ C: 10, A: 40 }, { C: 0, A: 5 }, { C: 200, A: -30 }]) {
        const found = page.solveRotaryAxes(new page.Vector3(...expectedValue), start, chain);
        const stands = page.toolDirection({ rotary_deg: found }, chain);
        const length = Math.hypot(...expectedValue);
        stands.toArray().forEach((value, i) => near(value, expectedValue[i] / length, 1e-7));
      }
    }
    const small = page.solveRotaryAxes(page.toolDirection({ rotary_deg: { C: 12, A: 41 } }, chain), { C: 10, A: 40 }, chain);
    near(small.C, 12, 1e-5);
    near(small.A, 41, 1e-5);
    assert.equal(page.solveRotaryAxes(new page.Vector3(1, 0, 0), { C: 0 }, chain), null, "one axis alone does not get there");
  },

  "an orientation is turned in the way that it is said": (page) => {
    const chain = new page.Chain(head());
    const about = turn(page, [0, 1, 0], 90);
    assert.deepEqual(page.rotateOrientation({ tool_axis: [0, 0, 1] }, about, null).tool_axis, [1, 0, 0]);
    const { rpy_deg } = page.rotateOrientation({ rpy_deg: [0, 0, 0] }, turn(page, [0, 0, 1], 30), null);
    rpy_deg.forEach((value, i) => near(value, [30, 0, 0][i], 1e-6));
    const { rotary_deg, tool_axis } = page.rotateOrientation({ rotary_deg: { C: 0, A: 50 } }, turn(page, [0, 0, 1], 20), chain);
    assert.equal(tool_axis, undefined);
    near(rotary_deg.C, 20, 1e-5);
    near(rotary_deg.A, 50, 1e-5);
    assert.equal(page.rotateOrientation({ rotary_deg: { C: 0, A: 50 } }, about, null), null, "no machine is known");
    assert.equal(page.rotateOrientation({}, about, chain), null);
  },

  "grips are where they are seen": (page) => {
    const setStandardView = standOf(page);
    const scale = page.handleScale(setStandardView);
    const along = (i, px) => seen(setStandardView, page.unitVector(i).multiplyScalar(px * scale));
    for (const i of [0, 1, 2]) assert.deepEqual(page.gripAt(setStandardView, ...along(i, 0.7 * page.ARROW_PX), true), { kind: "move", axis: i });
    assert.deepEqual(page.gripAt(setStandardView, ...along(0, 0), true), { kind: "plane", axis: 2 });
    const ring = seen(setStandardView, page.ringPoint(2, 0.8).multiplyScalar(page.RING_PX * scale));
    assert.deepEqual(page.gripAt(setStandardView, ...ring, true), { kind: "turn", axis: 2 });
    assert.equal(page.gripAt(setStandardView, ...ring, false), null);
    assert.equal(page.gripAt(setStandardView, 5, 5, true), null);
    assert.equal(page.mostVisiblePlane(standOf(page, "front")), 1, "the level plane is seen from its edge");
  },

  "a pull at an arrow or in a plane takes the point to the pointer": (page) => {
    for (const name of ["iso", "top"]) {
      const setStandardView = standOf(page, name);
      const expectedValue = new page.Vector3(37, 0, 0);
      const start = new page.Vector2(...seen(setStandardView, new page.Vector3()));
      const pull = new page.HandleDrag(setStandardView, { kind: "move", axis: 0 }, start);
      assert.ok(pull.shift(...seen(setStandardView, expectedValue)).distanceTo(expectedValue) < 1, "within a step");
      const inPlane = new page.Vector3(-20, 31, 0);
      assert.ok(new page.HandleDrag(setStandardView, { kind: "plane", axis: 2 }, start).shift(...seen(setStandardView, inPlane)).distanceTo(inPlane) < 1);
    }
    const setStandardView = standOf(page, "top");
    const down = new page.HandleDrag(setStandardView, { kind: "move", axis: 2 }, new page.Vector2(400, 300)).shift(500, 100);
    assert.deepEqual(down.toArray(), [0, 0, 0], "along the line of sight nothing can be said");
  },

  "a pull at a ring turns by the angle that it is pulled through": (page) => {
    const setStandardView = standOf(page);
    const at = (angle) => seen(setStandardView, page.ringPoint(2, angle).multiplyScalar(page.RING_PX * page.handleScale(setStandardView)));
    const pull = new page.HandleDrag(setStandardView, { kind: "turn", axis: 2 }, new page.Vector2(...at(0.3)));
    const { x, y, z, w } = pull.turn(...at(0.3 + Math.PI / 6));
    near(2 * Math.atan2(z, w), Math.PI / 6, 1e-6);
    assert.deepEqual([x, y].map(Math.abs), [0, 0]);
    // From its edge it is pulled along itself: a quarter of its radius to the right on the screen.
    const front = standOf(page, "front");
    const edge = new page.HandleDrag(front, { kind: "turn", axis: 2 }, new page.Vector2(400, 300)).turn(400 + page.RING_PX / 4, 300);
    near(Math.abs(2 * Math.atan2(edge.z, edge.w)), (Math.round((0.25 * 180) / Math.PI) * Math.PI) / 180, 1e-6);
  },

  "joints that are moved stay within their ranges, and are kept": (page) => {
    const store = new page.Store(page.initialState());
    const state = new page.JogState(store);
    assert.equal(state.frame, null);
    const { axes, tool_side, tcps_mm } = head();
    const run = runOf(page, [{ line: 1, duration_s: 1 }], { more: { axes, tool_side, tcps_mm } });
    run.robots[0].joints_at = () => [7, 0, 0];
    store.set("run", run);
    state.begin();
    assert.deepEqual(state.values, [7, 0, 5]);
    assert.equal(state.setValue(0, 250), false);
    assert.equal(state.setValue(1, -90), true);
    assert.deepEqual(state.values.map(Math.round), [200, -90, 5]);
    assert.equal(state.tool_mm, 30);
    state.frame.elements.slice(12, 15).forEach((value, i) => near(value, [0, 0, 170][i], 1e-9));
    state.end();
    assert.equal(store.get("jog"), null);
    state.begin();
    assert.deepEqual(state.values.map(Math.round), [200, -90, 5]);
    const other = runOf(page, [{ line: 1, duration_s: 1 }], { more: { axes, tool_side, tcps_mm, machine: "another" } });
    other.robots[0].joints_at = () => [9, 0, 0];
    store.set("run", other);
    state.begin();
    assert.deepEqual(state.values, [9, 0, 5], "another machine begins where its run is");
    state.setValue(0, 1);
    state.fromRun();
    assert.deepEqual(state.values, [9, 0, 5]);
  },

  "several points are chosen from the first one on": (page) => {
    const store = new page.Store(page.initialState());
    const choice = new page.TargetSelection(store);
    assert.equal(choice.range, null);
    choice.choose({ path: 1, target: 4 });
    choice.choose({ path: 1, target: 2 }, true);
    assert.deepEqual(choice.range, { place: { path: 1, target: 2 }, count: 3 });
    assert.deepEqual([choice.has({ path: 1, target: 3 }), choice.has({ path: 0, target: 3 })], [true, false]);
    choice.choose({ path: 1, target: 6 }, true);
    assert.deepEqual(choice.range, { place: { path: 1, target: 4 }, count: 3 });
    // By another part of the page.
    store.set("pathPoint", { path: 1, target: 5 });
    assert.deepEqual(choice.range, { place: { path: 1, target: 5 }, count: 1 });
    choice.choose({ path: 2, target: 0 }, true);
    assert.deepEqual(choice.range, { place: { path: 2, target: 0 }, count: 1 }, "of one path");
  },

  "the tree has what is open, and opens what hides a point": ({ toDisplayedPath, visibleRows, reveal, TreeState }) => {
    const point = '{"position_mm": [0, 0, 0]}';
    const many = Array.from({ length: 450 }, () => point).join();
    const text = `{"root": "a", "paths": [{"name": "b", "targets": [${many}]}, {"name": "a", "targets": [${point}, {"path": "b"}, {"path": "b", "repeats": 2}]}, {"name": "c", "targets": [${point}]}]}`;
    const displayed = toDisplayedPath("x.path.json", text);
    const state = new TreeState();
    const keys = () => [...visibleRows(displayed, state)].map(({ key }) => key);
    assert.deepEqual(keys(), ["1", "2"]);
    state.set("1", true);
    assert.deepEqual(keys(), ["1", "1/0", "1/1", "1/2", "2"]);
    reveal(displayed, state, { path: 0, target: 3 });
    assert.equal(keys().length, 5 + 200 + 1);
    reveal(displayed, state, { path: 0, target: 420 });
    assert.deepEqual([keys().includes("1/1/420"), keys().includes("1/1/3"), keys().length], [true, false, 5 + 200 + 1]);
    state.expand("1/1", 249);
    assert.deepEqual([keys().includes("1/1/249"), keys().length], [true, 5 + 330 + 1]);
    reveal(displayed, state, { path: 2, target: 0 });
    assert.equal(keys().at(-1), "2/0");
    const circle = toDisplayedPath("y", '{"paths": [{"name": "a", "targets": [{"path": "a"}]}]}');
    state.set("0", true);
    state.set("0/0", true);
    assert.deepEqual([...visibleRows(circle, state)].map(({ below, error }) => [below, error]), [[0, ""], [-1, "The path 'a' contains itself."]]);
  },
};

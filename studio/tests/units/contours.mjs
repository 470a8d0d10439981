// Contours of a part to choose from: the edges that identify a choice for the engine, and lines in space on
// the screen.

import assert from "node:assert/strict";
import { near } from "./made.mjs";

export const modules = ["panels/paths/contour_picks", "panels/paths/contour_camera", "panels/paths/contour_list", "panels/paths/engine_requests"];

const contour = (edges, more = {}) => ({ face: "the plane face #1", isHole: true, edges, length_mm: 30, depth_mm: 6, tilt_deg: 12, polyline_mm: new Float64Array(6), ...more });
const three = [contour(["#1", "#2"]), contour(["#3"]), contour(["#4", "#5"])];
const size = { width: 400, height: 200 };

/** Returns a square of 20 mm in the plane z = 0, around a position. */
const square = (x, y, z = 0) =>
  new Float64Array([[-10, -10], [10, -10], [10, 10], [-10, 10], [-10, -10]].flatMap(([dx, dy]) => [x + dx, y + dy, z]));
/** Straight from above, X to the right. */
const above = { yaw_rad: -Math.PI / 2, elevation_rad: Math.PI / 2, zoom: 1, pan_mm: [0, 0] };

export default {
  "an edge of each contour that is cut chooses it, and none where all are": ({ selectedEdges, selectedContours }) => {
    assert.equal(selectedEdges(three, [true, true, true]), undefined);
    assert.deepEqual(selectedEdges(three, [true, false, true]), ["#1", "#4"]);
    assert.deepEqual(selectedEdges(three, [false, false, false]), []);
    assert.deepEqual(selectedContours(three, undefined), [true, true, true]);
    assert.deepEqual(selectedContours(three, []), [false, false, false]);
    assert.deepEqual(selectedContours(three, ["#5", "#3"]), [false, true, true]);
  },

  "a contour that shares an edge with one that is not cut is chosen by another one": ({ selectedEdges, selectedContours }) => {
    const sharing = [contour(["#1", "#2"]), contour(["#1", "#9"]), contour(["", "#2"])];
    const picks = selectedEdges(sharing, [false, true, false]);
    assert.deepEqual(picks, ["#9"]);
    assert.deepEqual(selectedContours(sharing, picks), [false, true, false]);
  },

  "contours with the same edges, of a body that stands in an assembly twice, go together": ({ toggleContour }) => {
    const twins = [contour(["#1", "#2"]), contour(["#3"]), contour(["#1", "#2"])];
    assert.deepEqual(toggleContour(twins, [true, true, true], 2, false), [false, true, false]);
    assert.deepEqual(toggleContour(twins, [false, false, false], 1, true), [false, true, false]);
  },

  "what an earlier list of contours knew goes with it": ({ keepKnownEdges }) => {
    assert.equal(keepKnownEdges(three, undefined), undefined);
    assert.deepEqual(keepKnownEdges(three, []), []);
    assert.deepEqual(keepKnownEdges(three, ["#3", "#99"]), ["#3"]);
    assert.equal(keepKnownEdges(three, ["#99"]), undefined);
  },

  "without numbers of edges nothing can be picked": ({ areSelectable }) => {
    assert.equal(areSelectable(three), true);
    assert.equal(areSelectable([...three, contour(["", ""])]), false);
  },

  "a contour is told by kind, edge, face and sizes, in the page's unit": ({ contourText }) => {
    assert.equal(contourText(three[0], "mm"), "Hole at edge #1 of the plane face #1: 30.00 mm long, 6.00 mm deep, tilted by 12.0°");
    assert.match(contourText(contour([""], { isHole: false, length_mm: 25.4 }), "inch"), /^Outline of the plane face #1: 1\.000 in long/);
  },

  "lines are seen without perspective, and fit into the picture": ({ projectLine, lineExtent, pixelsPerMm }) => {
    const extent = lineExtent([square(0, 0), square(100, 0)], above);
    assert.deepEqual(extent.middle, [50, 0, 0]);
    near(extent.width_mm, 120);
    near(extent.height_mm, 20);
    const scale = pixelsPerMm(extent, above, size);
    near(scale * 120, 400 * 0.88, 1e-9);
    const line = projectLine(square(0, 0), extent, above, size);
    // Its first corner is to the left of the middle and below it.
    near(line[0], 200 - 60 * scale, 1e-4);
    near(line[1], 100 + 10 * scale, 1e-4);
    near(line[2] - line[0], 20 * scale, 1e-4);
    // Height does not show from above, and is all that shows from the side.
    near(projectLine(square(0, 0, 7), extent, above, size)[1], line[1], 1e-4);
    const level = { ...above, elevation_rad: 0 };
    near(projectLine(square(0, 0, 7), extent, level, size)[1], 100 - 7 * scale, 1e-4);
  },

  "faces that look to a side are seen from there": ({ initialCamera }) => {
    const towards = ({ yaw_rad, elevation_rad }) => [Math.cos(elevation_rad) * Math.cos(yaw_rad), Math.cos(elevation_rad) * Math.sin(yaw_rad), Math.sin(elevation_rad)];
    for (const [side, direction] of Object.entries({ x: [1, 0, 0], "-x": [-1, 0, 0], y: [0, 1, 0], "-y": [0, -1, 0], z: [0, 0, 1], "-z": [0, 0, -1] })) {
      const look = towards(initialCamera(side));
      assert.ok(look.reduce((sum, value, i) => sum + value * direction[i], 0) > 0.75, side);
    }
  },

  "a turn goes no further than straight above and below": ({ turned }) => {
    near(turned(above, 0, 500).elevation_rad, Math.PI / 2);
    near(turned(above, 0, -5000).elevation_rad, -Math.PI / 2);
    near(turned(above, 100, 0).yaw_rad, above.yaw_rad - 1);
  },

  "what is under the pointer stays there as the picture is zoomed": ({ projectLine, lineExtent, zoomCamera }) => {
    const extent = lineExtent([square(0, 0)], above);
    const before = projectLine(square(0, 0), extent, above, size);
    const camera = zoomCamera(above, 3, extent, size, before[2], before[3]);
    const after = projectLine(square(0, 0), extent, camera, size);
    near(after[2], before[2], 1e-3);
    near(after[3], before[3], 1e-3);
    near(after[2] - after[0], 3 * (before[2] - before[0]), 1e-3);
    const back = zoomCamera(camera, 1 / 3, extent, size, before[2], before[3]);
    near(back.pan_mm[0], 0, 1e-9);
    near(back.pan_mm[1], 0, 1e-9);
  },

  "the nearest line is found within some pixels": ({ projectLine, lineExtent, nearestLine }) => {
    const lines_mm = [square(0, 0), square(100, 0)];
    const extent = lineExtent(lines_mm, above);
    const lines = lines_mm.map((line) => projectLine(line, extent, above, size));
    const [x, y] = lines[1];
    assert.equal(nearestLine(lines, x + 3, y + 4, 9), 1);
    assert.equal(nearestLine(lines, (lines[0][0] + lines[0][2]) / 2, lines[0][1] - 2, 9), 0);
    assert.equal(nearestLine(lines, 200, 100, 9), -1);
    assert.equal(nearestLine([], 0, 0, 9), -1);
  },

  "the engine's list becomes contours with their lines": async ({ readContours }) => {
    const header = { is: "contours", contours: [
      { face: "a", is_hole: true, is_open: false, edges: ["#1"], length_mm: 1, depth_mm: 2, tilt_deg: 3, points: 2 },
      { face: "b", is_hole: false, is_open: false, edges: ["#2"], length_mm: 4, depth_mm: 5, tilt_deg: 6, points: 3 },
    ], notes: ["said"] };
    const columns = new Map([["lines", Float64Array.from({ length: 15 }, (_, i) => i)]]);
    const asked = [];
    const session = { sendRequest: (request) => (asked.push(request), Promise.resolve({ ok: true, code: "", message: "", messages: [{ is: "contours", header, columns }] })) };
    const { contours, notes } = await readContours(session, { drawing: "part.step", contours: { kind: "all" } });
    assert.deepEqual(asked, [{ do: "contours", drawing: "part.step", contours: { kind: "all" } }]);
    assert.deepEqual(notes, ["said"]);
    assert.deepEqual(contours.map(({ face, isHole, polyline_mm }) => [face, isHole, [...polyline_mm]]), [
      ["a", true, [0, 1, 2, 3, 4, 5]],
      ["b", false, [6, 7, 8, 9, 10, 11, 12, 13, 14]],
    ]);
    const refusing = { sendRequest: () => Promise.resolve({ ok: false, code: "input", message: "not read here", messages: [] }) };
    assert.deepEqual(await readContours(refusing, {}), { refused: "not read here" });
  },
};

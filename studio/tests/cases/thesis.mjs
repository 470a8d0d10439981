// The pictures of docs/thesis.md: what the figures of the thesis show, as it is here. Each is what a run or a form comes to, and that is
// looked at as well. With GSIM_RENEW_PICTURES=1 the pictures are written into docs/images.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { run, setState, untilSettled, state, withPage } from "../steps.mjs";

const SIZE = { width: 1280, height: 800 };
const CHARTS = { width: 900, height: 900 };
const FORMS = { width: 1600, height: 1400 };
const ACCELERATION_MM_S2 = 490.33; // of the gantry that is built in, as its rapids:
const RAPID_MM_S = 508;
const FEED_MM_S = 100; // F6000

const START = "G21 G90 G94\n";
const MOVES = {
  long: `${START}G1 X500 F6000\nM2\n`,
  short: `${START}G1 X5 F6000\nM2\n`,
  rapid: `${START}G0 X600 Y200\nM2\n`,
  linear: `${START}G1 X600 Y200 F6000\nM2\n`,
};

/** What the list of the form has. */
const GROUPS = ["Frames", "Fixed points", "Reference points", "Home positions", "Tools", "Variables", "Aliases", "Security zones", "Working zone"];

const CELL = `[cell]
name = "a trolley beside the gantry"

[[object]]
name = "trolley"
shape = { box_mm = [300.0, 200.0, 80.0] }
frame = { x_mm = 500.0, y_mm = 400.0, z_mm = 40.0 }

[[object]]
name = "part"
role = "workpiece"
attached_to = "trolley"
shape = { box_mm = [120.0, 80.0, 60.0] }
frame = { z_mm = 70.0 }
`;
/** Program: the trolley moves 800 mm at 100 mm/s and turns by a quarter, while the tool continues. */
const LED = `local _ENV = require "gsim"
G0{x=200, y=1000, z=300}
assert(rrs.SelectObject("trolley") == 0)
assert(rrs.SetObjectSpeed(100) == 0)
assert(rrs.SetObjectNextTarget{{0, -1, 0, 1300}, {1, 0, 0, 400}, {0, 0, 1, 40}, {0, 0, 0, 1}} == 0)
F(6000) G1{x=1600}
`;

const near = (value, expected, tolerance = 1e-9) => assert.ok(Math.abs(value - expected) < tolerance, `${value} is not ${expected}`);

/** Writes a picture of a part of the page, with its full height or so many pixels. */
async function picture(page, places, name, locator, height = Infinity) {
  const box = await locator.boundingBox();
  await pictureOf(page, places, name, { ...box, height: Math.min(box.height, height) });
}

async function pictureOf(page, places, name, clip) {
  await untilSettled(page);
  if (!process.env.GSIM_RENEW_PICTURES) return;
  await page.screenshot({ path: join(places.samples, `../docs/images/thesis-${name}.png`), clip });
}

/** Returns the area of the view for a box of the work, with a margin. */
const onScreen = (page, from_mm, to_mm, margin_px) =>
  page.evaluate(
    ([from, to, margin]) => {
      const corners = [0, 1, 2, 3, 4, 5, 6, 7].map((bits) => window.studio.view.screenPosition([0, 1, 2].map((i) => ((bits >> i) & 1 ? to : from)[i])));
      const [left, top] = [0, 1].map((i) => Math.min(...corners.map((at) => at[i])) - margin);
      const [right, bottom] = [0, 1].map((i) => Math.max(...corners.map((at) => at[i])) + margin);
      return { x: left, y: top, width: right - left, height: bottom - top };
    },
    [from_mm, to_mm, margin_px],
  );

/** Returns the segments of the run, with the accelerations of the parts of their law. */
const segments = (page) =>
  page.evaluate(() => {
    const { scene, segments } = window.studio.store.get("run").robots[0];
    return segments.chunks.flatMap(({ count, duration_s, flags, record, values }) =>
      Array.from({ length: count }, (_, i) => {
        const law = record[i] + 2 * scene.axes.length;
        const accelerations = Array.from({ length: values[law + 3] }, (_, section) => values[law + 4 + 5 * section + 3]);
        return { duration_s: duration_s[i], apart: (flags[i] & 64) !== 0, accelerations };
      }),
    );
  });

async function onlyMove(page, program, setup = {}, files = {}) {
  const { status, error } = await run(page, { program: "move.nc", ...setup }, { "move.nc": program, ...files });
  assert.equal(status, "completed", error);
  const all = (await segments(page)).filter(({ duration_s }) => duration_s > 0);
  assert.equal(all.length, 1);
  return all[0];
}

async function chooseChart(page, expectedValue) {
  const box = (name) => page.locator("#time .chooser").getByLabel(name, { exact: true });
  for (const name of ["Speed and feed", "Axis speeds"]) await box(name).setChecked(name === expectedValue);
  await box("% of limit").setChecked(false);
  for (const letter of ["Z", "B", "C"]) await box(letter).setChecked(false);
}

const chart = (page) => page.locator("#time");
const tab = (page, name) => page.locator("#side").getByRole("tab", { name, exact: true }).click();

export default {
  "figures of the thesis: velocity profiles and interpolation": (places) =>
    withPage(
      places.studio,
      async (page) => {
        await chooseChart(page, "Speed and feed");
        const long = await onlyMove(page, MOVES.long);
        assert.deepEqual(long.accelerations.map(Math.sign), [1, 0, -1]);
        near(long.duration_s, 500 / FEED_MM_S + FEED_MM_S / ACCELERATION_MM_S2);
        await picture(page, places, "profile-long", chart(page));

        const short = await onlyMove(page, MOVES.short);
        assert.deepEqual(short.accelerations.map(Math.sign), [1, -1]);
        near(short.duration_s, 2 * Math.sqrt(5 / ACCELERATION_MM_S2));
        await picture(page, places, "profile-short", chart(page));

        await chooseChart(page, "Axis speeds");
        const joint = await onlyMove(page, MOVES.rapid);
        assert.equal(joint.apart, false);
        near(joint.duration_s, 600 / RAPID_MM_S + RAPID_MM_S / ACCELERATION_MM_S2);
        await picture(page, places, "joint", chart(page));

        const machine = `${readFileSync(join(places.samples, "machines/af5.toml"), "utf8")}\n[controller]\ninterpolated_rapids = false\n`;
        const apart = await onlyMove(page, MOVES.rapid, { machine: "apart.toml" }, { "apart.toml": machine });
        assert.equal(apart.apart, true);
        near(apart.duration_s, joint.duration_s);
        await picture(page, places, "joint-apart", chart(page));

        const linear = await onlyMove(page, MOVES.linear);
        near(linear.duration_s, Math.hypot(600, 200) / FEED_MM_S + FEED_MM_S / ACCELERATION_MM_S2);
        await picture(page, places, "linear", chart(page));
      },
      CHARTS,
    ),

  "figures of the thesis: a program and its translation, and an object that is led": (places) =>
    withPage(
      places.studio,
      async (page) => {
        assert.equal((await run(page, { program: "samples/cell/left.nc" })).status, "completed");
        await page.locator("#code").getByRole("button", { name: "Both", exact: true }).click();
        await page.locator("#code .cm-line").filter({ hasText: "G1{x=200" }).waitFor();
        await picture(page, places, "translation", page.locator("#code"));

        const { status, error } = await run(page, { program: "led.lua", cell: "trolley.toml" }, { "led.lua": LED, "trolley.toml": CELL });
        assert.equal(status, "completed", error);
        const [{ scene }] = (await state(page, "run")).robots;
        assert.deepEqual(scene.drifts.map(({ velocity_mm_s }) => Math.round(Math.hypot(...velocity_mm_s))), [100, 0]);
        near(scene.drifts[1].from_s - scene.drifts[0].from_s, 8);
        await page.addStyleTag({ content: "#view > :not(.surface) { visibility: hidden !important; }" });
        for (const [name, after_s] of [["object-begin", 0], ["object-end", 6]]) {
          await setState(page, "time_s", scene.drifts[0].from_s + after_s);
          await pictureOf(page, places, name, await onScreen(page, [100, 100, 0], [1750, 1250, 500], 10));
        }
      },
      SIZE,
    ),

  "figures of the thesis: the form of the control's data": (places) =>
    withPage(
      places.studio,
      async (page) => {
        assert.equal((await run(page, { program: "samples/wheel.nc", machine_data: "samples/jet.txt" })).status, "completed");
        await tab(page, "Data");
        const form = page.locator("#side .data-form");
        const list = form.getByRole("combobox", { name: "Stored data of the controller" });
        await form.locator("tbody tr").first().waitFor();
        await picture(page, places, "data", page.locator("#side"), 390);

        assert.deepEqual(await list.locator("option").allInnerTexts(), GROUPS);
        await list.focus();
        await picture(page, places, "data-list", list);

        await form.locator("tbody tr").first().dblclick();
        const dialog = page.locator("dialog.data-entry");
        await dialog.getByLabel("X", { exact: true }).fill("12.5");
        await picture(page, places, "data-entry", dialog);
        await dialog.getByRole("button", { name: "OK" }).click();
        await form.locator("tbody tr").filter({ hasText: "12.5" }).waitFor();
      },
      SIZE,
    ),

  "figures of the thesis: a path, a geometric point, and the program": (places) =>
    withPage(
      places.studio,
      async (page) => {
        await tab(page, "Paths");
        await setState(page, "pathFile", "samples/wheel.path.json");
        await page.waitForFunction(() => window.studio.store.get("path")?.file);
        await setState(page, "pathPoint", { path: 1, target: 1 });
        const { paths } = (await state(page, "path")).file;
        assert.deepEqual(paths[1].targets[1].via_mm, [284.1, 500, 52]);
        const form = page.locator("#side .paths");
        await picture(page, places, "point", page.locator("#side"), 790);
        await pictureOf(page, places, "path", await onScreen(page, [284, 284, 52], [716, 716, 52], 60));

        await form.locator(".write .primary").click();
        await page.waitForFunction(() => /wheel.*\.nc/.test(window.studio.store.get("run")?.report?.program) && !window.studio.store.get("running"), null, { timeout: 60_000 });
        const { program } = await page.evaluate(() => window.studio.store.get("run").report);
        assert.match(await page.evaluate((name) => window.studio.documents.text(name), program), /G0?[23] /);
        await picture(page, places, "program", page.locator("#code"), 620);
      },
      FORMS,
    ),
};

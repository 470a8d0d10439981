// Path forms other than points: fixed and reference points, work frames and tools, up to the words of the
// program.

import assert from "node:assert/strict";
import { run, setState, state, withPage } from "../steps.mjs";

const DATA = "NCFILE\nFIXED\n1 300 20 -30 NAME=CLAMP1\n7 350 60 -10\nREFERENCE\n1 400 300 -5 NAME=DOCK\nENDFILE\n";
const PATH = `{"name": "job", "paths": [
{"name": "job", "targets": [
  {"motion": "rapid", "position_mm": [0, 0, 20]},
  {"position_mm": [0, 0, 5], "feed_mm_min": 300},
  {"motion": "rapid", "position_mm": [0, 0, 20]},
  {"path": "part"}
]},
{"name": "part", "targets": [
  {"motion": "rapid", "position_mm": [10, 0, 20]}
]}
]}
`;

const form = (page) => page.locator("#side .paths");
const button = (page, name) => form(page).getByRole("button", { name });
/** Of the form that is seen. */
const field = (page, label) => form(page).getByLabel(label, { exact: true }).and(page.locator(":visible"));
const pathText = (page) => page.evaluate(() => window.studio.store.get("path").text);
const paths = (page) => page.evaluate(() => window.studio.store.get("path").file.paths);
const said = (page) => form(page).locator(".said").textContent();
const undoLabel = (page) => page.evaluate(() => window.studio.session.history.undoLabel);
const choose = (page, path, target) => setState(page, "pathPoint", { path, target });

async function chosenTarget(page) {
  const { path, target } = await state(page, "pathPoint");
  return (await paths(page))[path].targets[target];
}

async function put(page, label, value) {
  await field(page, label).fill(String(value));
  await field(page, label).press("Enter");
}

/** A page with a path, and machine data with points. */
const withPath = (places, test, text = PATH) =>
  withPage(places.studio, async (page) => {
    const files = { "square.nc": "G21 G90 G54\nG0 X10\nM2\n", "shop.txt": DATA, "job.path.json": text };
    const { status } = await run(page, { program: "square.nc", machine: "samples/machines/router3.toml", dialect: "ab9", machine_data: "shop.txt" }, files);
    assert.equal(status, "completed");
    await page.locator("#side").getByRole("tab", { name: "Paths", exact: true }).click();
    await setState(page, "pathFile", "job.path.json");
    await page.waitForFunction(() => window.studio.store.get("path")?.name === "job.path.json");
    await test(page);
  });

export default {
  "a fixed point is added by its name, changed, and taken back": (places) =>
    withPath(places, async (page) => {
      await choose(page, 0, 2);
      await button(page, "Add a fixed or reference point").click();
      assert.deepEqual(await state(page, "pathPoint"), { path: 0, target: 3 });
      assert.deepEqual(await chosenTarget(page), { fixed: "CLAMP1" });
      const options = await field(page, "Point").locator("option").allInnerTexts();
      assert.deepEqual(options, ["CLAMP1 (1)", "7", "another one, by number or name"]);
      await field(page, "Point").selectOption("7");
      assert.deepEqual(await chosenTarget(page), { fixed: 7 });
      await put(page, "Identifier", "PARK");
      assert.match(await form(page).locator(".form .note:visible").textContent(), /^shop\.txt has no fixed point 'PARK'\.$/);
      await put(page, "Identifier", "2nd");
      assert.match(await said(page), /Not changed: 'fixed' must be the number of a fixed point, or its name/);
      assert.deepEqual(await chosenTarget(page), { fixed: "PARK" });
      await field(page, "Kind").selectOption("reference");
      assert.deepEqual(await chosenTarget(page), { reference: 1 });
      await field(page, "Point").selectOption("DOCK");
      await put(page, "Dwell on arrival, s", 2);
      await field(page, "action, such as waterjet_on").fill("clamp");
      await field(page, "action, such as waterjet_on").press("Enter");
      await put(page, "Name", "left");
      assert.deepEqual(await chosenTarget(page), { name: "left", reference: "DOCK", dwell_s: 2, actions: ["clamp"] });
      assert.match(await form(page).locator("[aria-selected=true]").innerText(), /left: reference point DOCK/);
      // Only a rapid may follow it.
      await button(page, "Add a point").click();
      assert.equal((await chosenTarget(page)).motion, "rapid");
      assert.deepEqual(await page.evaluate(() => window.studio.store.get("path").walk.errors), []);
      await page.locator("#undo-button").click();
      assert.equal(await undoLabel(page), "changing a fixed or reference point");
      while (await undoLabel(page)) await page.locator("#undo-button").click();
      assert.equal(await pathText(page), PATH);
      await page.locator("#redo-button").click();
      assert.deepEqual((await paths(page))[0].targets[3], { fixed: "CLAMP1" });
      // Later entries of the data are offered, too.
      await choose(page, 0, 3);
      await page.evaluate((text) => window.studio.documents.put("shop.txt", text), DATA.replace("7 350 60 -10", "8 350 60 -10 NAME=PARK"));
      await field(page, "Point").locator("option", { hasText: "PARK (8)" }).waitFor({ state: "attached" });
    }),

  "a path is given a work offset and a tool, and the program has their words and those of a fixed point": (places) =>
    withPath(places, async (page) => {
      await choose(page, 0, 2);
      await button(page, "Add a fixed or reference point").click();
      await choose(page, 0, -1);
      assert.deepEqual([await field(page, "Position").count(), await field(page, "Length offset").count()], [0, 0]);
      await put(page, "Work offset", "G55");
      await field(page, "Position").selectOption("program");
      for (const [letter, value] of [["X", 320], ["Y", 40], ["Z", -60]]) await put(page, `Its origin in machine coordinates ${letter}, mm`, value);
      await put(page, "Tool", 3);
      await put(page, "Length offset, 3 if empty", 4);
      const [job] = await paths(page);
      assert.deepEqual({ ...job, targets: [] }, { name: "job", work_offset: "G55", set_offset_mm: [320, 40, -60], tool: 3, length_offset: 4, targets: [] });
      await put(page, "Tool", 1.5);
      assert.match(await said(page), /Not changed: 'tool' must be an integer from 0/);
      assert.equal((await paths(page))[0].tool, 3);

      // The use of a sub-path has its own frame.
      await choose(page, 0, 4);
      await put(page, "Work offset", "G56");
      await field(page, "Position").selectOption("program");
      await put(page, "Its origin in machine coordinates X, mm", 350);
      assert.deepEqual(await chosenTarget(page), { path: "part", work_offset: "G56", set_offset_mm: [350, 0, 0] });
      await put(page, "Its origin in machine coordinates Z, mm", -60);
      await page.locator("#side .write .primary").click();
      await page.waitForFunction(() => window.studio.store.get("run")?.report?.program === "job.nc" && !window.studio.store.get("running"), null, { timeout: 60_000 });
      assert.equal(await page.evaluate(() => window.studio.store.get("run").report.status), "completed");
      const program = await page.evaluate(() => window.studio.documents.text("job.nc"));
      for (const words of [/G10 L2 P2 X320\.000 Y40\.000 Z-60\.000/, /G10 L2 P3 X350\.000 Y0\.000 Z-60\.000/, /T3\n.*M06\n.*G43 H4\n.*G55/, /G53 G00 X300\.000 Y20\.000\n.*G53 G00 Z-30\.000/, /G56/]) {
        assert.match(program, words);
      }

      // A frame that the post does not have is refused, with those that it has.
      await put(page, "Work offset", "G77");
      await page.locator("#side .write .primary").click();
      await page.locator("#side .write .fault").filter({ hasText: "G77" }).waitFor();

      // An emptied field is removed, with its dependent fields.
      await put(page, "Work offset", "");
      assert.deepEqual(await chosenTarget(page), { path: "part" });
      await choose(page, 0, -1);
      await field(page, "Position").selectOption("control");
      assert.equal((await paths(page))[0].set_offset_mm, undefined);
      await put(page, "Work offset", "");
      await put(page, "Tool", "");
      assert.deepEqual(Object.keys((await paths(page))[0]), ["name", "targets"]);
      assert.equal(await undoLabel(page), "changing work offset or tool of a path");
      await page.locator("#undo-button").click();
      assert.deepEqual([(await paths(page))[0].tool, (await paths(page))[0].length_offset], [3, 4]);
    }),

  "touches that find a work offset are kept, and a recorded path takes neither frames nor machine points": (places) => {
    const touch = '{"axis": "Z", "from_mm": [0, 0, 9], "to_mm": -1, "surface_mm": 0, "feed_mm_min": 60}';
    const text = PATH.replace('"name": "part",', `"name": "part", "work_offset": "G55", "probe_offset": [${touch}],`);
    return withPath(
      places,
      async (page) => {
        await choose(page, 1, -1);
        assert.match(await form(page).locator(".form .note:visible").textContent(), /measures it by a touch/);
        await put(page, "Work offset", "");
        assert.match(await said(page), /Not changed: 'probe_offset' requires 'work_offset'/);
        assert.equal(await pathText(page), text);
        const recorded = PATH.replace('"paths"', '"work_offsets": {"54": {"X": 1}}, "paths"');
        await page.evaluate((own) => window.studio.documents.put("job.path.json", own), recorded);
        await choose(page, 0, -1);
        assert.equal(await field(page, "Tool").count(), 0);
        assert.match(await form(page).locator(".form .note:visible").textContent(), /recorded from a run/);
        await button(page, "Add a fixed or reference point").click();
        assert.match(await said(page), /Not added: a path that was recorded/);
        assert.equal(await pathText(page), recorded);
      },
      text,
    );
  },
};

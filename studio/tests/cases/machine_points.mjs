// Forms of paths beside points: fixed and reference points, work frames and tools, as far as the words of the program.

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
const choose = (page, path, target) => setState(page, "pathPoint", { path, target });
const theme = (page, name) => setState(page, "theme", name);

async function chosenTarget(page) {
  const { path, target } = await state(page, "pathPoint");
  return (await paths(page))[path].targets[target];
}

async function put(page, label, value) {
  await field(page, label).fill(String(value));
  await field(page, label).press("Enter");
}

const pictures = process.env.GSIM_FORM_PICTURES;

/** A page with a path, and machine data with points. */
const withPath = (places, test, text = PATH) =>
  withPage(
    places.studio,
    async (page) => {
      const files = { "square.nc": "G21 G90 G54\nG0 X10\nM2\n", "shop.txt": DATA, "job.path.json": text };
      const { status } = await run(page, { program: "square.nc", machine: "samples/machines/router3.toml", dialect: "ab9", machine_data: "shop.txt" }, files);
      assert.equal(status, "completed");
      await page.locator("#side").getByRole("tab", { name: "Paths", exact: true }).click();
      await setState(page, "pathFile", "job.path.json");
      await page.waitForFunction(() => window.studio.store.get("path")?.name === "job.path.json");
      await test(page);
    },
    { width: 1280, height: 1000 },
  );

export default {
  "a fixed point is added by its name, changed, and taken back": (places) =>
    withPath(places, async (page) => {
      await choose(page, 0, 2);
      await button(page, "Add a fixed or reference point").click();
      assert.deepEqual(await state(page, "pathPoint"), { path: 0, target: 3 });
      assert.deepEqual(await chosenTarget(page), { fixed: "CLAMP1" });
      const options = await field(page, "Which").locator("option").allInnerTexts();
      assert.deepEqual(options, ["CLAMP1 (1)", "7", "another one, by number or name"]);
      await field(page, "Which").selectOption("7");
      assert.deepEqual(await chosenTarget(page), { fixed: 7 });
      await put(page, "Number or name", "PARK");
      assert.match(await form(page).locator(".form .note:visible").textContent(), /^shop\.txt has no fixed point 'PARK'\.$/);
      await put(page, "Number or name", "2nd");
      assert.match(await said(page), /Not changed: 'fixed' must be the number of a fixed point, or its name/);
      assert.deepEqual(await chosenTarget(page), { fixed: "PARK" });
      await field(page, "Kind").selectOption("reference");
      assert.deepEqual(await chosenTarget(page), { reference: 1 });
      await field(page, "Which").selectOption("DOCK");
      await put(page, "Wait on arrival, s", 2);
      await field(page, "action, such as waterjet_on").fill("clamp");
      await field(page, "action, such as waterjet_on").press("Enter");
      await put(page, "Name", "left");
      assert.deepEqual(await chosenTarget(page), { name: "left", reference: "DOCK", dwell_s: 2, actions: ["clamp"] });
      assert.match(await form(page).locator("[aria-selected=true]").innerText(), /left: reference point DOCK/);
      // Behind it only a rapid may come.
      await button(page, "Add a point").click();
      assert.equal((await chosenTarget(page)).motion, "rapid");
      assert.deepEqual(await page.evaluate(() => window.studio.store.get("path").walk.faults), []);
      const undoLabel = () => page.evaluate(() => window.studio.session.history.undoLabel);
      await page.locator("#undo-button").click();
      assert.equal(await undoLabel(), "changing a fixed or reference point");
      while (await undoLabel()) await page.locator("#undo-button").click();
      assert.equal(await pathText(page), PATH);
      await page.locator("#redo-button").click();
      assert.deepEqual((await paths(page))[0].targets[3], { fixed: "CLAMP1" });
      // What the data have later is offered, too.
      await choose(page, 0, 3);
      await page.evaluate((text) => window.studio.documents.put("shop.txt", text), DATA.replace("7 350 60 -10", "8 350 60 -10 NAME=PARK"));
      await field(page, "Which").locator("option", { hasText: "PARK (8)" }).waitFor({ state: "attached" });
      if (pictures) {
        for (const name of ["light", "dark"]) {
          await theme(page, name);
          await page.screenshot({ path: `${pictures}/point-${name}.png` });
        }
      }
    }),
};

// Manual paths: from a drawing or from an empty file, changed in the tree, the form and the view, written,
// run and compared with the path.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { dropFiles, withPage, untilSettled, state } from "../steps.mjs";

const docs = (places) => join(places.samples, "../docs/images");
const WHEEL = "samples/wheel.path.json";

/** Max deviation of a round trip: paths are drawn within 0.01 mm, programs rounded to 0.001. */
const NEAR_MM = 0.02;

const tab = (page, name) => page.locator("#side").getByRole("tab", { name, exact: true }).click();
const form = (page) => page.locator("#side .paths");
const button = (page, name) => form(page).getByRole("button", { name });
const field = (page, label) => form(page).getByLabel(label, { exact: false }).first();
const pathText = (page) => page.evaluate(() => window.studio.store.get("path").text);
const file = (page) => page.evaluate(() => window.studio.store.get("path").file);
const history = (page) => page.evaluate(() => window.studio.session.history.undoLabel);
const choose = (page, path, target) => page.evaluate((place) => window.studio.store.set("pathPoint", place), { path, target });
const rows = (page) => page.locator("#side [role=treeitem]");

/** Types into a field, and leaves it. */
async function put(page, label, value) {
  await field(page, label).fill(String(value));
  await field(page, label).press("Enter");
}

async function openPath(page, name) {
  await tab(page, "Paths");
  await page.evaluate((path) => window.studio.store.set("pathFile", path), name);
  await untilSettled(page);
}

/** The chosen point, as the file has it. */
const chosenPoint = (page) =>
  page.evaluate(() => {
    const { path, target } = window.studio.store.get("pathPoint");
    return window.studio.store.get("path").file.paths[path].targets[target];
  });

/** Pulls the arrow of the chosen point along an axis by so many pixels on the screen. */
async function pull(page, axis, by_px, steps = 8) {
  const { position_mm } = await chosenPoint(page);
  const ends = await page.evaluate(
    ([at, to]) => [at, to].map((point) => window.studio.view.screenPosition(point)),
    [position_mm, position_mm.map((value, i) => value + (i === axis ? 5 : 0))],
  );
  const length = Math.hypot(ends[1][0] - ends[0][0], ends[1][1] - ends[0][1]);
  const along = [0, 1].map((i) => (ends[1][i] - ends[0][i]) / length);
  const at = (px) => [ends[0][0] + px * along[0], ends[0][1] + px * along[1]];
  await page.mouse.move(...at(40));
  await page.mouse.down();
  for (let i = 1; i <= steps; ++i) await page.mouse.move(...at(40 + (by_px * i) / steps));
  return { drop: () => page.mouse.up() };
}

/** Writes for a controller, waits for the run, and returns the deviation between both paths, mm. */
async function writeFor(page, post, program) {
  await page.locator("#side .write").getByLabel("Post", { exact: true }).selectOption(post);
  const write = page.locator("#side .write .primary");
  await write.click();
  await page.waitForFunction(
    (name) => window.studio.store.get("run")?.report?.program === name && !window.studio.store.get("running"),
    program,
    { timeout: 60_000 },
  );
  return roundTrip(page, program);
}

async function roundTrip(page, program) {
  const said = page.locator("#side .round-trip");
  await page.waitForFunction(
    (name) => document.querySelector("#side .round-trip").textContent.includes(`path of ${name} is`),
    program,
    { timeout: 30_000 },
  );
  const [, way, path] = (await said.textContent()).match(/is at most ([\d.]+) mm off .* path file at most ([\d.]+) mm off/);
  const { status } = await page.evaluate(() => window.studio.store.get("run").report);
  return { travel_mm: Number(way), path_mm: Number(path), status };
}

function assertNear({ travel_mm, path_mm, status }) {
  assert.equal(status, "completed");
  assert.ok(travel_mm < NEAR_MM && path_mm < NEAR_MM, `${travel_mm} and ${path_mm} mm`);
}

async function download(page, act) {
  const waiting = page.waitForEvent("download");
  await act();
  const saved = await waiting;
  return { name: saved.suggestedFilename(), text: readFileSync(await saved.path(), "utf8") };
}

export default {
  "a dropped drawing becomes a path, which is changed by hand, written for two controls, and run": (places) =>
    withPage(
      places.studio,
      async (page) => {
        await dropFiles(page, join(places.samples, "plate.svg"));
        const dialog = page.getByRole("dialog", { name: "Path from drawing" });
        await dialog.waitFor();
        await dialog.getByRole("button", { name: "Make path" }).click();
        await dialog.getByRole("alert").filter({ hasText: "needs 'material' and 'thickness_mm'" }).waitFor();
        await dialog.getByLabel("Material").selectOption("aluminum");
        await dialog.getByLabel("Thickness").fill("12");
        for (const [letter, value] of [["X", 200], ["Y", 200], ["Z", 50]]) await dialog.getByLabel(`Origin at ${letter}`).fill(String(value));
        await dialog.getByRole("button", { name: "Make path" }).click();
        await page.waitForFunction(() => window.studio.store.get("path")?.name === "plate.path.json");
        assert.match(await form(page).locator(".said").textContent(), /7 contours, 7 pierces, 725\.9 mm cut/);
        assert.equal((await file(page)).paths.length, 8);

        // A click on a mark selects its point; its handle moves it, by one step that is undone and redone.
        await untilSettled(page);
        const { position_mm } = (await file(page)).paths[1].targets[5];
        await page.mouse.click(...(await page.evaluate((at) => window.studio.view.screenPosition(at), position_mm)));
        assert.deepEqual(await state(page, "pathPoint"), { path: 1, target: 5 });
        const before = await pathText(page);
        await (await pull(page, 0, 30)).drop();
        const moved = await chosenPoint(page);
        assert.ok(moved.position_mm[0] > position_mm[0] + 1, `${moved.position_mm}`);
        assert.deepEqual(moved.position_mm.slice(1), position_mm.slice(1));
        assert.equal(await history(page), "moving a point");
        assert.deepEqual((await page.evaluate(() => window.studio.store.get("path").walk.errors)).map(({ text }) => text), []);
        await page.locator("#undo-button").click();
        assert.equal(await pathText(page), before);
        await page.locator("#redo-button").click();
        assert.deepEqual(await chosenPoint(page), moved);

        // Feed and order.
        await put(page, "Feed, mm/min", 200);
        assert.equal((await chosenPoint(page)).feed_mm_min, 200);
        await choose(page, 0, 1);
        await button(page, "Move up").click();
        assert.deepEqual((await file(page)).paths[0].targets.slice(0, 2).map(({ path }) => path), ["contour 2", "contour 1"]);
        assert.deepEqual(await state(page, "pathPoint"), { path: 0, target: 0 });

        assertNear(await writeFor(page, "ab9", "plate.nc"));
        const { program, dialect } = await page.evaluate(() => ({ ...window.studio.session.setup }));
        assert.deepEqual([program, dialect], ["plate.nc", "ab9"]);
        await choose(page, 1, 5);
        await page.locator("#side").evaluate((side) => (side.scrollTop = 0));
        await untilSettled(page);
        if (process.env.GSIM_RENEW_PICTURES) await page.screenshot({ path: join(docs(places), "studio-path.png") });
        const first_s = await page.evaluate(() => window.studio.store.get("run").report.cycle_time_s);
        assertNear(await writeFor(page, "rs274ngc", "plate.ngc"));
        assert.equal(await page.evaluate(() => window.studio.session.setup.dialect), "rs274ngc");

        // Saved, and opened in another page: the same.
        const saved = await download(page, () => button(page, "Save").click());
        assert.equal(saved.name, "plate.path.json");
        assert.equal(saved.text, await pathText(page));
        await withPage(places.studio, async (second) => {
          const chooser = second.waitForEvent("filechooser");
          await second.locator("#open-button").click();
          await (await chooser).setFiles({ name: saved.name, mimeType: "application/json", buffer: Buffer.from(saved.text) });
          await second.waitForFunction(() => window.studio.store.get("path")?.name === "plate.path.json");
          assertNear(await writeFor(second, "ab9", "plate.nc"));
          const again_s = await second.evaluate(() => window.studio.store.get("run").report.cycle_time_s);
          assert.equal(again_s, first_s);
        });
      },
      { width: 1280, height: 800 },
    ),

  "a path is begun from nothing, and grows by keys": (places) =>
    withPage(places.studio, async (page) => {
      await tab(page, "Paths");
      await button(page, "New").click();
      assert.equal(await state(page, "pathFile"), "part.path.json");
      for (const [x, y] of [[300, 300], [400, 300], [400, 380]]) {
        await button(page, "Add a point").click();
        await put(page, "Position X", x);
        await put(page, "Position Y", y);
        await put(page, "Position Z", 40);
      }
      await form(page).getByLabel("Motion").selectOption("circular");
      assert.ok((await chosenPoint(page)).via_mm);
      await form(page).getByLabel("Arc", { exact: true }).selectOption("center");
      const { center_mm, turn_deg, via_mm } = await chosenPoint(page);
      assert.ok(center_mm && turn_deg > 0 && via_mm === undefined);
      const names = async () => (await file(page)).paths[0].targets.map(({ position_mm, path }) => path ?? position_mm.slice(0, 2).join());

      // Arrows choose, with Alt they move, with Shift they choose more; Insert copies, Delete deletes.
      await rows(page).nth(2).click();
      await page.keyboard.press("ArrowDown");
      assert.deepEqual(await state(page, "pathPoint"), { path: 0, target: 2 });
      await page.keyboard.press("Alt+ArrowUp");
      assert.deepEqual((await names()).slice(1), ["400,300", "300,300", "400,380"]);
      assert.equal(await page.evaluate(() => document.activeElement.getAttribute("aria-selected")), "true", "the focus goes along");
      await page.keyboard.press("Alt+ArrowDown");
      await page.keyboard.press("Insert");
      assert.equal((await names()).length, 5);
      await page.keyboard.press("Delete");
      assert.deepEqual((await names()).slice(1), ["300,300", "400,300", "400,380"]);
      await page.keyboard.press("ArrowUp");
      await page.keyboard.press("Shift+ArrowDown");
      await button(page, "Make a separate sub-path").click();
      assert.deepEqual((await names()).slice(1), ["300,300", "sub-path"]);
      assert.equal((await file(page)).paths[1].targets.length, 2);
      await put(page, "Times", 3);
      // A row moves to its drop position: before a row that is above it.
      const times = (await file(page)).paths[0].targets.length;
      await rows(page).nth(times).dragTo(rows(page).nth(1));
      assert.deepEqual((await names())[0], "sub-path");
      await page.evaluate(() => window.studio.session.history.undo());
      await choose(page, 0, times - 1);
      assert.deepEqual((await chosenPoint(page)).repeats, 3);
      await put(page, "Times", "1.5");
      assert.match(await form(page).locator(".said").textContent(), /Not changed: 'repeats' must be an integer/);
      for (let undo = await history(page); undo; undo = await history(page)) await page.evaluate(() => window.studio.session.history.undo());
      assert.equal(await state(page, "pathFile"), "", "a file that was begun goes with its first step");
      assert.equal(await page.evaluate(() => window.studio.documents.get("part.path.json")), undefined);
    }),

  "values that are taken over stand in grey, and what is typed wrongly is said": (places) =>
    withPage(places.studio, async (page) => {
      await openPath(page, WHEEL);
      await choose(page, 1, 2);
      const feed = field(page, "Feed, mm/min, 6350 if empty");
      assert.deepEqual([await feed.inputValue(), await feed.getAttribute("placeholder")], ["", "6350"]);
      await feed.fill("fast");
      await feed.press("Enter");
      assert.equal(await feed.getAttribute("aria-invalid"), "true");
      assert.equal(await pathText(page), await page.evaluate((name) => window.studio.documents.samples.get(name), WHEEL));
      await feed.fill("-1");
      await feed.press("Enter");
      assert.match(await form(page).locator(".said").textContent(), /Not changed: 'feed_mm_min' must be a number greater than 0/);
      await page.evaluate(() => window.studio.store.set("units", "inch"));
      const inches = field(page, "Feed, in/min");
      assert.equal(await inches.getAttribute("placeholder"), "250");
      await inches.fill("100");
      await inches.press("Enter");
      assert.equal((await chosenPoint(page)).feed_mm_min, 2540);
      await field(page, "Feed, in/min").fill("");
      await field(page, "Feed, in/min").press("Enter");
      assert.equal((await chosenPoint(page)).feed_mm_min, undefined, "emptied it is taken over again");
      // A change leaves all other text as written.
      assert.equal(await pathText(page), await page.evaluate((name) => window.studio.documents.samples.get(name), WHEEL));
    }),

  "Escape puts a point back that is being pulled": (places) =>
    withPage(places.studio, async (page) => {
      await openPath(page, WHEEL);
      await choose(page, 1, 1);
      await untilSettled(page);
      const before = await pathText(page);
      const { drop } = await pull(page, 1, 40);
      assert.notEqual(await pathText(page), before, "it is seen while it is pulled");
      await page.locator("#view .surface").focus();
      await page.keyboard.press("Escape");
      await drop();
      assert.equal(await pathText(page), before);
      assert.equal(await history(page), "");
    }),

  "a ring turns the tool, and rotary axes stay rotary axes": (places) =>
    withPage(places.studio, async (page) => {
      await openPath(page, WHEEL);
      await page.evaluate(() => window.studio.view.setStandardView("top"));
      await choose(page, 2, 0);
      await untilSettled(page);
      const { position_mm, rotary_deg } = await chosenPoint(page);
      const [x, y] = await page.evaluate((at) => window.studio.view.screenPosition(at), position_mm);
      // From above, the ring about Z is a circle: by 20 degrees.
      const at = (degrees) => [x + 84 * Math.cos((degrees * Math.PI) / 180), y - 84 * Math.sin((degrees * Math.PI) / 180)];
      await page.mouse.move(...at(200));
      await page.mouse.down();
      for (let i = 1; i <= 10; ++i) await page.mouse.move(...at(200 + 2 * i));
      await page.mouse.up();
      assert.equal(await history(page), "turning the tool");
      const turned = await chosenPoint(page);
      assert.deepEqual(turned.position_mm, position_mm);
      assert.ok(Math.abs(turned.rotary_deg.B - rotary_deg.B - 20) < 1.5, JSON.stringify(turned.rotary_deg));
      assert.ok(Math.abs(turned.rotary_deg.C - rotary_deg.C) < 1e-3);
    }),

  "leads are added to a contour, and it is written with them": (places) =>
    withPage(places.studio, async (page) => {
      const text = `{"paths": [{"name": "cut", "targets": [
        {"motion": "rapid", "position_mm": [300, 300, 60], "tool_axis": [0, 0, 1]},
        {"motion": "rapid", "position_mm": [300, 300, 50], "actions": ["waterjet_on"]},
        {"position_mm": [400, 300, 50], "feed_mm_min": 3000},
        {"position_mm": [400, 400, 50]},
        {"position_mm": [300, 300, 50], "actions": ["waterjet_off"]}
      ]}]}`;
      await page.evaluate((own) => window.studio.documents.put("cut.path.json", own), text);
      await openPath(page, "cut.path.json");
      await choose(page, 0, -1);
      await page.locator("#side .leads > summary").click();
      await put(page, "Radius, length", 6);
      await button(page, "Add leads").click();
      const { targets } = (await file(page)).paths[0];
      assert.deepEqual(targets.map(({ motion }) => motion ?? "linear"), ["rapid", "rapid", "circular", "linear", "linear", "linear", "circular"]);
      assert.deepEqual(targets[1].position_mm, [294, 294, 50]);
      assert.deepEqual(targets.at(-1).actions, ["waterjet_off"]);
      assertNear(await writeFor(page, "ab9", "cut.nc"));
    }),

  "what a control has no word for is refused in words, and goes on as a comment": (places) =>
    withPage(places.studio, async (page) => {
      await openPath(page, WHEEL);
      await choose(page, 1, 1);
      await field(page, "action, such as").fill("sound_horn");
      await field(page, "action, such as").press("Enter");
      assert.deepEqual((await chosenPoint(page)).actions, ["sound_horn"]);
      await page.locator("#side .write .primary").click();
      const refused = page.locator("#side .write .fault").first();
      await refused.filter({ hasText: "sound_horn" }).waitFor();
      await page.locator("#side .write details > summary").click();
      await page.locator("#side .write").getByLabel("unsupported features as comments").check();
      await page.locator("#side .write").getByLabel("rotary values as given").check();
      assertNear(await writeFor(page, "ab9", "wheel.nc"));
      assert.match(await page.locator("#side .write .notes").textContent(), /sound_horn/);
      assert.match(await page.evaluate(() => window.studio.documents.text("wheel.nc")), /sound_horn/);
      // The sample of that name lies in another folder, and is as it was.
      assert.equal(await page.evaluate(() => window.studio.documents.own("samples/wheel.nc")), undefined);
      await choose(page, 1, 1);
      await put(page, "Position X", 501);
      assert.match(await page.locator("#side .round-trip").textContent(), /The path has changed since wheel\.nc was written/);
    }),

  "a post of one's own writes sub-paths into files of their own, and all of them run": (places) =>
    withPage(places.studio, async (page) => {
      await page.evaluate(() => {
        const { documents } = window.studio;
        documents.put("posts/mine.toml", documents.text("samples/posts/rs274ngc.toml").replace(/name = "rs274ngc"/, 'name = "mine"'));
      });
      await openPath(page, WHEEL);
      await form(page).locator(".write details > summary").click();
      await form(page).getByLabel("sub-paths in separate files").check();
      await form(page).getByLabel("rotary values as given").check();
      await form(page).getByLabel("Program", { exact: true }).fill("out/ring.ngc");
      await form(page).getByLabel("Program", { exact: true }).press("Enter");
      assertNear(await writeFor(page, "posts/mine.toml", "out/ring.ngc"));
      const names = await page.evaluate(() => window.studio.documents.userFileNames().filter((name) => name.startsWith("out/")));
      assert.ok(names.length === 4, names.join());
      assert.equal(await page.evaluate(() => window.studio.session.setup.dialect), "rs274ngc");
      await page.evaluate(() => window.studio.session.history.undo());
      assert.deepEqual(await page.evaluate(() => window.studio.documents.userFileNames().filter((name) => name.startsWith("out/"))), []);
    }),

  "a file that is no path is said with its line": (places) =>
    withPage(places.studio, async (page) => {
      const chooser = page.waitForEvent("filechooser");
      await page.locator("#open-button").click();
      const buffer = Buffer.from('{"paths": [\n{"name": "a", "targets": [{"position_mm": [1, 2]}]}]}');
      await (await chooser).setFiles({ name: "broken.path.json", mimeType: "application/json", buffer });
      await page.locator("#side .paths > .fault").filter({ hasText: "Line 2, column 27: 'position_mm' must contain three numbers" }).waitFor();
      assert.equal(await page.locator("#side .write .primary").isDisabled(), true);
    }),
};

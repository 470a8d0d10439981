// Machine and cell in forms: changed, undone, saved, opened again in another page, and run.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { run, untilSettled, state, withPage } from "../steps.mjs";

const ROUTER = "samples/machines/router3.toml";
const MOVE = { "move.nc": "G21 G90\nG0 X500\nM30\n" };

/**
 * Returns the time from standstill to standstill over a distance, mm: at a speed (mm/s) and an acceleration
 * (mm/s2), if it is long enough for them.
 */
const moveTime = (way, speed, acceleration) => way / speed + speed / acceleration;

const form = (page) => page.locator(".machine-form");
const openForm = async (page, tab = "Machine") => {
  await page.locator("#side .side-bar").getByRole("tab", { name: "Machine" }).click();
  await form(page).getByRole("tab", { name: tab, exact: true }).click();
};
const section = (page, title) => form(page).locator("details.section:visible").filter({ has: page.locator(`summary:text-is("${title}")`) });
const openSection = async (page, title) => {
  const found = section(page, title);
  if ((await found.getAttribute("open")) === null) await found.locator("summary").first().click();
  return found;
};
/** A card by its title, opened. */
const openCard = async (page, title) => {
  const card = form(page).locator("details.card:visible").filter({ has: page.locator(`summary > b:text-is("${title}")`) });
  // The engine may be looking at all bodies of the machine before it makes the card.
  if ((await card.getAttribute("open", { timeout: 90_000 })) === null) await card.locator("summary").first().click();
  return card;
};
/** A card has fields for both kinds of axes, or all shapes, of which some are in sight. */
const field = (scope, label) => scope.getByLabel(label, { exact: true }).locator("visible=true");
const fill = async (scope, label, value) => {
  await field(scope, label).fill(value);
  await field(scope, label).press("Tab");
};

const setup = (page) => page.evaluate(() => ({ ...window.studio.session.setup }));
const text = (page, name) => page.evaluate((file) => window.studio.documents.text(file), name);
const report = (page) => page.evaluate(() => window.studio.store.get("run").report);
const ranIn = (page, time_s) =>
  page.waitForFunction((expectedValue) => Math.abs((window.studio.store.get("run")?.report?.cycle_time_s ?? -1) - expectedValue) < 1e-3, time_s, { timeout: 20_000 });
/** Waits until a document contains a text. */
const hasText = (page, name, part) =>
  page.waitForFunction(([file, expectedValue]) => window.studio.documents.text(file).includes(expectedValue), [name, part], { timeout: 10_000 });

/** The lines that are others in a text, by their numbers. */
function changedLines(before, after) {
  const [a, b] = [before.split("\n"), after.split("\n")];
  assert.equal(a.length, b.length, "as many lines as before");
  return a.flatMap((line, i) => (line === b[i] ? [] : [`${i + 1}: ${b[i]}`]));
}

/** What a click on Save gives: its name and bytes. */
async function saved(page, button) {
  const download = page.waitForEvent("download");
  await button.click();
  const file = await download;
  return { name: file.suggestedFilename(), bytes: readFileSync(await file.path()) };
}

/** Opens files by the dialog, as a person does. */
async function openFiles(page, files) {
  const chooser = page.waitForEvent("filechooser");
  await page.locator("#open-button").click();
  const given = files.map(({ name, bytes }) => ({ name, mimeType: "text/plain", buffer: Buffer.from(bytes) }));
  await (await chooser).setFiles(given);
}

export default {
  "a speed of the machine is changed: the time is that of physics, its line alone is another one, and it can be saved and opened": (places) =>
    withPage(places.studio, async (page) => {
      const before = await run(page, { program: "move.nc", machine: ROUTER }, MOVE);
      assert.ok(Math.abs(before.cycle_time_s - moveTime(500, 150, 500)) < 1e-6);
      await openForm(page);
      const sample = await text(page, ROUTER);
      await fill(await openCard(page, "X"), "Max speed", "100");
      await ranIn(page, moveTime(500, 100, 500));
      assert.equal((await setup(page)).machine, "my-router3.toml");
      assert.equal(await text(page, ROUTER), sample, "the sample stays");
      assert.deepEqual(changedLines(sample, await text(page, "my-router3.toml")), ["23: max_speed_mm_s = 100.0"]);

      await page.locator("#undo-button").click();
      await ranIn(page, moveTime(500, 150, 500));
      assert.equal((await setup(page)).machine, ROUTER);
      assert.equal(await field(await openCard(page, "X"), "Max speed").inputValue(), "150");
      await page.locator("#redo-button").click();
      await ranIn(page, moveTime(500, 100, 500));
      await fill(await openCard(page, "X"), "Max acceleration", "400");
      await ranIn(page, moveTime(500, 100, 400));

      const file = await saved(page, form(page).locator(".file-row:visible").getByRole("button", { name: "Save" }));
      assert.equal(file.name, "my-router3.toml");
      assert.equal(file.bytes.toString(), await text(page, "my-router3.toml"));
      await withPage(places.studio, async (other) => {
        await run(other, { program: "move.nc" }, MOVE);
        await openFiles(other, [file]);
        await ranIn(other, moveTime(500, 100, 400));
        await openForm(other);
        assert.equal(await field(await openCard(other, "X"), "Max speed").inputValue(), "100");
      });
    }),

  "the machine's form is in inches where the page is, and keeps the keyboard's place": (places) =>
    withPage(places.studio, async (page) => {
      await run(page, { program: "move.nc", machine: ROUTER }, MOVE);
      await openForm(page);
      await page.getByRole("button", { name: "Millimetres or inches" }).click();
      const card = await openCard(page, "X");
      const speed = field(card, "Max speed");
      assert.equal(await speed.inputValue(), "5.90551181");
      await speed.fill("4");
      await speed.press("Enter");
      await hasText(page, "my-router3.toml", "max_speed_mm_s = 101.6");
      await ranIn(page, moveTime(500, 101.6, 500));
      assert.equal(await speed.evaluate((field) => field === document.activeElement), true);
      await speed.press("Tab");
      assert.equal(await field(card, "Max acceleration").evaluate((field) => field === document.activeElement), true);
    }),

  "what is no number is not taken, and said; Escape takes back what was typed": (places) =>
    withPage(places.studio, async (page) => {
      await run(page, { program: "move.nc", machine: ROUTER }, MOVE);
      await openForm(page);
      const card = await openCard(page, "X");
      const speed = field(card, "Max speed");
      await fill(card, "Max speed", "fast");
      assert.match(await card.locator(".key-fault:visible").innerText(), /“fast” is not a number/);
      await speed.focus();
      await speed.press("Escape");
      assert.equal(await speed.inputValue(), "150");
      assert.equal(await card.locator(".key-fault:visible").count(), 0);
      assert.equal((await setup(page)).machine, ROUTER);
    }),

  "an axis is added, moved and removed, and each is one step back": (places) =>
    withPage(places.studio, async (page) => {
      await run(page, { program: "move.nc", machine: ROUTER }, MOVE);
      await openForm(page);
      const letters = () => form(page).locator("details.card:visible > summary > b").allInnerTexts();
      await openCard(page, "X");
      await form(page).getByRole("button", { name: "Add a rotary axis" }).click();
      await page.waitForFunction(() => document.querySelectorAll(".machine-form details.card summary > b")[3]?.textContent === "A");
      assert.deepEqual(await letters(), ["X", "Y", "Z", "A"]);
      await (await openCard(page, "A")).getByRole("button", { name: "Remove" }).click();
      await page.waitForFunction(() => window.studio.session.history.undoLabel === "A: removed");
      assert.equal(await text(page, "my-router3.toml"), await text(page, ROUTER));
      await page.locator("#undo-button").click();
      await hasText(page, "my-router3.toml", 'letter = "A"');
    }),

  "parameters of the control are changed where they stand: in the machine's file, or in the controller's": (places) =>
    withPage(places.studio, async (page) => {
      const own = '# Mine.\n[controller]\nmodel = "ab9"\nsettle_s = 0.5   # measured\n';
      const machine = (await text(page, ROUTER)).replace("[process]", '[controller]\nmodel = "mine.toml"\n\n[process]');
      // At both exact stops the axes settle.
      const program = { "stops.nc": "G21 G90 G61\nG1 X250 F6000\nX500\nM30\n" };
      const still = 2 * moveTime(250, 100, 500);
      const before = await run(page, { program: "stops.nc", machine: "shop.toml" }, { ...program, "mine.toml": own, "shop.toml": machine });
      assert.ok(Math.abs(before.cycle_time_s - still - 2 * 0.5) < 1e-6);
      await openForm(page);
      const control = await openSection(page, "Controller");
      assert.match(await control.innerText(), /until the axes are in position/);
      await fill(control, "Settle", "0.75");
      await ranIn(page, still + 2 * 0.75);
      // The comment stays in place.
      const changed = own.replace("0.5   #", "0.75  #");
      assert.equal(await text(page, "mine.toml"), changed);
      assert.equal(await text(page, "shop.toml"), machine);

      // The machine's own table has priority; without either the model's value applies.
      await field(control, "Model").selectOption("ab9");
      await ranIn(page, still);
      assert.equal(await text(page, "shop.toml"), machine.replace('"mine.toml"', '"ab9"'));
      await fill(control, "Settle", "0.25");
      await ranIn(page, still + 2 * 0.25);
      assert.equal(await text(page, "mine.toml"), changed);
      await fill(control, "Settle", "");
      await ranIn(page, still);
      for (let i = 0; i < 4; ++i) await page.locator("#undo-button").click();
      assert.deepEqual([await text(page, "mine.toml"), await text(page, "shop.toml")], [own, machine]);
    }),

  "a machine with an error is shown with its place, mended in the text, and runs": (places) =>
    withPage(places.studio, async (page) => {
      await run(page, { program: "move.nc" }, MOVE);
      const broken = (await text(page, ROUTER)).replace("max_speed_mm_s = 150.0", "max_sped_mm_s = 150.0");
      await openFiles(page, [{ name: "broken.toml", bytes: broken }]);
      await openForm(page);
      const error = form(page).locator(".faults:visible li").first();
      assert.match(await error.innerText(), /broken\.toml:23:1 unknown key 'max_sped_mm_s'.*max_speed_mm_s/s);
      // Valid TOML is shown as a form all the same.
      await fill(await openCard(page, "Y"), "Max speed", "140");
      await hasText(page, "broken.toml", "max_speed_mm_s = 140.0");
      await error.getByRole("button").click();
      await page.waitForFunction(() => /1 error/.test(document.getElementById("code").innerText), null, { timeout: 10_000 });
      assert.ok((await page.locator("#code .cm-lintRange-error").count()) > 0);
      assert.match(await page.locator("#code .cm-activeLine").first().innerText(), /max_sped_mm_s/);
      await page.keyboard.press("Home");
      for (let i = 0; i < 7; ++i) await page.keyboard.press("ArrowRight");
      await page.keyboard.type("e");
      await page.keyboard.press("Control+Enter");
      await ranIn(page, moveTime(500, 150, 500));
      await form(page).locator(".faults:visible").waitFor({ state: "detached", timeout: 10_000 }).catch(() => {});
      assert.equal(await form(page).locator(".faults:visible li").count(), 0);
    }),

  "what is no TOML at all is told of, and mended in the text": (places) =>
    withPage(places.studio, async (page) => {
      await run(page, { program: "move.nc" }, MOVE);
      const sound = await text(page, ROUTER);
      await openFiles(page, [{ name: "cut.toml", bytes: sound.replace('letter = "Y"', 'letter = "Y') }]);
      await openForm(page);
      await form(page).locator(".faults:visible li").first().waitFor();
      assert.match(await form(page).locator(".faults:visible").innerText(), /cut\.toml:28:/);
      assert.equal(await form(page).locator("details.card:visible").count(), 0);
      await form(page).getByRole("button", { name: "Edit as text" }).locator("visible=true").click();
      await page.evaluate(() => window.studio.store.set("requestedLocation", { file: "cut.toml", line: 28 }));
      await page.keyboard.press("End");
      await page.keyboard.type('"');
      await openCard(page, "Y");
      await page.keyboard.press("Control+Enter");
      await ranIn(page, moveTime(500, 150, 500));
    }),

  "a new machine of each kind passes its check and runs a program": (places) =>
    withPage(places.studio, async (page) => {
      const kinds = [
        ["3-axis router", "blend", "G21 G90\nG1 X100 Y50 F3000\nX200\nM30\n"],
        ["3-axis mill", "linuxcnc-2.9", "G21 G90\nG1 X100 Y50 F3000\nX200\nM30\n"],
        ["5-axis gantry with head", "ab9", "G21 G90\nG1 X100 C20 A10 F3000\nX200\nM30\n"],
        ["5-axis mill, tilting and turning table", "blend", "G21 G90\nG1 X100 A-20 C90 F3000\nM30\n"],
        ["5-axis mill, head and table", "grbl-1.1", "G21 G90\nG1 X100 B20 C90 F3000\nM30\n"],
        ["6-joint arm", "ab9", "G21 G90\nG1 A20 B50 V40 F2000\nM30\n"],
      ];
      for (const [i, [kind, control, program]] of kinds.entries()) {
        await openForm(page);
        await form(page).getByRole("button", { name: "New machine…" }).click();
        const dialog = page.getByRole("dialog", { name: "New machine" });
        await field(dialog, "Kind").selectOption({ label: kind });
        await dialog.locator("fieldset").first().waitFor();
        await page.waitForFunction((expectedValue) => document.querySelector("dialog.wizard pre").textContent.includes("[[axis]]") && !document.querySelector("dialog.wizard .primary").disabled && expectedValue, kind, { timeout: 20_000 });
        await fill(dialog, "Name", `Number ${i}`);
        const first = dialog.locator("fieldset").first();
        await fill(first, "Max speed", "77");
        await fill(first, "Max jerk", "9000");
        await field(dialog, "Controller").selectOption(control);
        await page.waitForFunction(
          ([name, model]) => {
            const displayed = document.querySelector("dialog.wizard pre").textContent;
            return displayed.includes(`name = "${name}"`) && displayed.includes(`model = "${model}"`) && !document.querySelector("dialog.wizard .primary").disabled;
          },
          [`Number ${i}`, control],
          { timeout: 20_000 },
        );
        assert.equal(await dialog.locator(".faults:visible").count(), 0);
        await dialog.getByRole("button", { name: "Create", exact: true }).click();
        await dialog.waitFor({ state: "detached" });
        const file = `number-${i}.toml`;
        assert.equal((await setup(page)).machine, file);
        const checked = await page.evaluate(async (machine) => {
          const { ok, message, messages } = await window.studio.session.sendRequest({ do: "machine", machine });
          return { ok, message, diagnostics: messages.filter(({ is }) => is === "diagnostic").length, inverse: messages.find(({ is }) => is === "machine")?.header.check.inverse };
        }, file);
        assert.ok(checked.ok, `${kind}: ${checked.message}`);
        assert.deepEqual([checked.diagnostics, checked.inverse.unsolved, checked.inverse.off], [0, 0, 0], kind);
        const ran = await run(page, { program: "try.nc", machine: file }, { "try.nc": program });
        assert.equal(ran.status, "completed", `${kind}: ${ran.error}`);
        const first_axis = await page.evaluate(() => window.studio.store.get("run").robots[0].scene.axes[0]);
        assert.deepEqual([first_axis.max_speed, first_axis.max_jerk], [77, 9000]);
        const [remark] = (await text(page, file)).split("\n");
        assert.match(remark, new RegExp(`^# Number ${i}: made from the sample`));
      }
      await page.locator("#undo-button").click();
    }),

  "an object is made, moved by number and by hand until something touches it, saved and opened again": (places) =>
    withPage(places.studio, async (page) => {
      const collisions = async (of = page) => [...new Set((await report(of)).collisions.flatMap(({ pair }) => pair))];
      const touched = (name, expectedValue, of = page) =>
        of.waitForFunction(
          ([body, is]) => window.studio.store.get("run")?.report?.collisions?.some(({ pair }) => pair.includes(body)) === is,
          [name, expectedValue],
          { timeout: 20_000 },
        );
      await run(page, { program: "samples/cell/clamp.nc", cell: "samples/cell/table.toml" });
      assert.deepEqual((await collisions()).includes("left clamp"), true);
      await openForm(page, "Cell");
      await openSection(page, "Objects");
      await form(page).getByRole("button", { name: "Add a box" }).locator("visible=true").click();
      const card = await openCard(page, "box");
      await page.waitForFunction(() => window.studio.store.get("handle") !== null);
      await fill(card, "Name", "stop block");
      const block = await openCard(page, "stop block");
      for (const [label, value] of Object.entries({ "Size X": "40", "Size Y": "40", "Size Z": "40", X: "150", Y: "300", Z: "25" })) await fill(block, label, value);
      await hasText(page, "my-table.toml", "z_mm = 25");
      await touched("stop block", false);
      const cell = await text(page, "my-table.toml");
      assert.match(cell, /# The jet passes through the slats/);
      assert.match(cell, /name = "stop block"\nshape = \{ box_mm = \[40/);

      // By hand: from above, the arrow along X, to the slot.
      await page.evaluate(() => window.studio.view.setStandardView("top"));
      await untilSettled(page);
      const [from, to] = await page.evaluate(() => [[150, 300, 25], [240, 300, 25]].map((point) => window.studio.view.screenPosition(point)));
      const arrow = [from[0] + 60, from[1]];
      await page.mouse.move(...arrow);
      await page.waitForTimeout(200);
      await page.mouse.down();
      await page.mouse.move(arrow[0] + (to[0] - from[0]) / 2, arrow[1], { steps: 4 });
      await page.mouse.move(arrow[0] + (to[0] - from[0]), arrow[1], { steps: 4 });
      await page.mouse.up();
      await touched("stop block", true);
      const x_mm = Number(await field(block, "X").inputValue());
      assert.ok(x_mm > 200 && x_mm < 280, `moved to ${x_mm}`);
      assert.deepEqual(changedLines(cell, await text(page, "my-table.toml")).length, 1);
      await page.locator("#undo-button").click();
      await touched("stop block", false);
      await page.locator("#redo-button").click();
      await touched("stop block", true);

      const file = await saved(page, form(page).locator(".file-row:visible").getByRole("button", { name: "Save" }));
      const before = await report(page);
      await withPage(places.studio, async (other) => {
        await run(other, { program: "samples/cell/clamp.nc" });
        await openFiles(other, [file]);
        await touched("stop block", true, other);
        const after = await report(other);
        assert.deepEqual(after.collisions, before.collisions);
        assert.equal(after.cycle_time_s, before.cycle_time_s);
      });
    }),

  "objects are duplicated, attached, removed and allowed to touch; what hung on them stays where it is": (places) =>
    withPage(places.studio, async (page) => {
      await run(page, { program: "samples/cell/clamp.nc", cell: "samples/cell/table.toml" });
      await openForm(page, "Cell");
      await openSection(page, "Objects");
      await (await openCard(page, "left clamp")).getByRole("button", { name: "Duplicate" }).click();
      const copy = await openCard(page, "left clamp 2");
      await field(copy, "Attached to").selectOption("table");
      await hasText(page, "my-table.toml", 'attached_to = "table"\nshape = { box_mm = [60.0, 40.0, 40.0] }\nframe = { x_mm = 0.0, y_mm = 300.0');
      const place = () =>
        page.evaluate(() => {
          const [robot] = window.studio.store.get("run").robots;
          const frame = robot.scene.frames.findIndex(({ name }) => name === "left clamp 2");
          return frame < 0 ? null : robot.chain.linkPoses(robot.joints_at(0), 0).frames[frame].elements.slice(12, 15);
        });
      await page.waitForFunction(() => window.studio.store.get("run").robots[0].scene.frames.some(({ name }) => name === "left clamp 2"));
      await page.waitForTimeout(1500);
      const before = await place();
      await (await openCard(page, "table")).getByRole("button", { name: "Remove" }).click();
      await page.waitForFunction(() => window.studio.store.get("run").robots[0].scene.bodies.every(({ name }) => name !== "table"), null, { timeout: 10_000 });
      (await place()).forEach((value, i) => assert.ok(Math.abs(value - before[i]) < 1e-6));
      assert.match(await text(page, "my-table.toml"), /^ignore = \[\["jet", "slats"\]\]/m);
      assert.equal((await report(page)).status === "input_file", false);

      const pairs = await openSection(page, "Allowed contacts");
      await pairs.getByLabel("First body").selectOption("nozzle end");
      await pairs.getByLabel("Second body").selectOption("left clamp");
      await pairs.getByRole("button", { name: "Add", exact: true }).click();
      await page.waitForFunction(() => !window.studio.store.get("run").report.collisions?.some(({ pair }) => pair.includes("left clamp") && pair.includes("nozzle end")), null, { timeout: 10_000 });
      await pairs.getByRole("button", { name: /nozzle end – left clamp/ }).click();
      await page.waitForFunction(() => window.studio.store.get("run").report.collisions?.some(({ pair }) => pair.includes("left clamp") && pair.includes("nozzle end")), null, { timeout: 10_000 });
    }),

  "a cell is made where there is none, a mesh becomes an object at a click, and distances are told": (places) =>
    withPage(places.studio, async (page) => {
      await run(page, { program: "move.nc", machine: "samples/machines/mill-table-table.toml" }, { "move.nc": "G21 G90\nG0 X10\nM30\n" });
      const mesh = readFileSync(join(places.samples, "cell/mould.stl"));
      await openFiles(page, [{ name: "own mould.stl", bytes: mesh }]);
      await openForm(page, "Cell");
      await form(page).getByRole("button", { name: "Make a cell" }).click();
      await form(page).getByRole("button", { name: "Add own mould.stl as an object" }).click();
      const card = await openCard(page, "own mould");
      await fill(card, "X", "2000");
      await page.waitForFunction(() => window.studio.store.get("run").robots[0].scene.bodies.some(({ name }) => name === "own mould"), null, { timeout: 10_000 });
      assert.match(await text(page, "my-cell.toml"), /machine = "samples\/machines\/mill-table-table\.toml"/);
      await form(page).getByRole("button", { name: "Add a sphere" }).locator("visible=true").click();
      const ball = await openCard(page, "sphere");
      await fill(ball, "Diameter", "20");
      await fill(ball, "Z", "-2000");
      await page.waitForFunction(() => window.studio.documents.text("my-cell.toml").includes("z_mm = -2000"));
      await page.waitForTimeout(1500);
      const distance = await openSection(page, "Distance");
      await field(distance, "From").selectOption("sphere");
      await field(distance, "To").selectOption("column");
      // The column's lower edge in front: on a base at 25, 75 before its middle at y 510, 500 below that at z 300.
      const expected = Math.hypot(510 - 75, 25 + 300 - 500 + 2000) - 10;
      await page.waitForFunction((mm) => Math.abs(parseFloat(document.querySelector(".machine-form output.distance").textContent) - mm) < 0.01, expected, { timeout: 10_000 });
    }),

  "a click on a body in the view opens it in the form": (places) =>
    withPage(places.studio, async (page) => {
      await run(page, { program: "samples/cell/clamp.nc", cell: "samples/cell/table.toml" });
      await openForm(page, "Cell");
      await page.evaluate(() => window.studio.view.setStandardView("top"));
      await page.evaluate(() => window.studio.view.fit(true));
      await untilSettled(page);
      const [x, y] = await page.evaluate(() => window.studio.view.screenPosition([1100, 400, 40]));
      await page.mouse.click(x, y);
      await page.waitForFunction(() => document.querySelector(".machine-form details.card[open] > summary > b")?.textContent === "right clamp", null, { timeout: 5000 });
      await page.waitForFunction(() => window.studio.store.get("handle")?.pose[12] === 1000);
    }),

  "the machine's and the cell's form, in pictures": (places) =>
    withPage(
      places.studio,
      async (page) => {
        const picture = async (name) => {
          await untilSettled(page);
          if (process.env.GSIM_RENEW_PICTURES) await page.screenshot({ path: join(places.samples, `../docs/images/studio-${name}.png`) });
        };
        await run(page, { program: "samples/wheel.nc", machine: "samples/machines/af5-measured.toml" });
        await openForm(page);
        await fill(await openCard(page, "B"), "Max acceleration", "45");
        await hasText(page, "my-af5-measured.toml", "max_acceleration_deg_s2 = 45.0");
        await page.waitForFunction(() => window.studio.store.get("run").report.cycle_time_s > 131);
        await picture("machine");
        await run(page, { program: "samples/cell/clamp.nc", cell: "samples/cell/table.toml" });
        await openForm(page, "Cell");
        await openCard(page, "left clamp");
        await picture("cell");
        assert.notEqual(await state(page, "handle"), null);
      },
      { width: 1280, height: 800 },
    ),
};

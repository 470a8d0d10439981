// Undo and redo of all changes by the user; the bar keeps its position under the keyboard.

import assert from "node:assert/strict";
import { join } from "node:path";
import { state, withPage } from "../steps.mjs";

const WHEEL = "samples/wheel.nc";
const MEASURED = "samples/machines/af5-measured.toml";
const LARGE = "samples/machines/af5.toml";

const ENDLESS = "local _ENV = require 'gsim'\nprogram(1, function()\n  F(6000) while true do G1{x=100} G1{x=0} end\nend)\n";

const setup = (page) => page.evaluate(() => ({ ...window.studio.session.setup }));
const textOf = (page, name) => page.evaluate((of) => window.studio.documents.text(of), name);
const cycle_s = (page) => page.evaluate(() => window.studio.store.get("run").report.cycle_time_s);
const focused = (page) => page.evaluate(() => document.activeElement.id || document.activeElement.getAttribute("aria-label"));
const machine = (page) => page.getByRole("combobox", { name: "Machine", exact: true });

/** Waits until the run that is shown is another one, as `act` brings it about. */
async function runAnew(page, act) {
  await page.evaluate(() => (window.shownBefore = window.studio.store.get("run")));
  await act();
  await page.waitForFunction(() => window.studio.store.get("run") !== window.shownBefore, null, { timeout: 20_000 });
}

const editor = (page) => page.locator("#code .cm-content").first();
const leaveEditor = (page) => page.locator("#view .surface").focus();

/** Types after the feed of line N210. */
async function typeFeed(page, digits) {
  await page.locator("#code .cm-line").filter({ hasText: /^N210 / }).first().click();
  await page.keyboard.press("End");
  await page.keyboard.type(digits);
}

export default {
  "a chosen machine is taken back by its button, done again by a key, and run": (places) =>
    withPage(places.studio, async (page) => {
      assert.equal(await page.locator("#undo-button").getAttribute("aria-disabled"), "true");
      await runAnew(page, () => machine(page).selectOption(LARGE));
      assert.equal(await page.locator("#undo-button").getAttribute("title"), "Undo: machine (af5.toml) (Ctrl+Z)");
      const other_s = await cycle_s(page);
      await runAnew(page, () => page.locator("#undo-button").click());
      assert.equal((await setup(page)).machine, MEASURED);
      assert.equal(await machine(page).inputValue(), MEASURED);
      assert.equal(await cycle_s(page), 129.989152064);
      assert.equal(await state(page, "notice"), "Undone: machine (af5.toml)");
      assert.equal(await focused(page), "undo-button");
      await runAnew(page, () => page.keyboard.press("Control+Shift+Z"));
      assert.equal((await setup(page)).machine, LARGE);
      assert.equal(await cycle_s(page), other_s);
      await page.keyboard.press("Control+z");
      await page.keyboard.press("Control+y");
      assert.equal((await setup(page)).machine, LARGE);
      assert.equal(await page.locator("#redo-button").getAttribute("title"), "Nothing to redo (Ctrl+Shift+Z)");
    }),

  "a typed edit is taken back outside the editor, and the editor's own undo goes on": (places) =>
    withPage(places.studio, async (page) => {
      const before = await textOf(page, WHEEL);
      await typeFeed(page, "7");
      const typed = await textOf(page, WHEEL);
      assert.notEqual(typed, before);
      await leaveEditor(page);
      await runAnew(page, () => page.keyboard.press("Control+z"));
      assert.equal(await textOf(page, WHEEL), before);
      assert.match(await page.locator("#code").innerText(), /C0 F6350$/m);
      assert.doesNotMatch(await page.locator("#code .code-mark").innerText(), /edited/);
      await runAnew(page, () => page.keyboard.press("Control+Shift+z"));
      assert.equal(await textOf(page, WHEEL), typed);
      // In the editor each is an edit like one that is typed.
      await editor(page).focus();
      await page.keyboard.press("Control+z");
      assert.equal(await textOf(page, WHEEL), before);
      await page.keyboard.press("Control+z");
      assert.equal(await textOf(page, WHEEL), typed);
    }),

  "what the editor's undo took away, and what was typed over it, are both still there": (places) =>
    withPage(places.studio, async (page) => {
      const before = await textOf(page, WHEEL);
      await typeFeed(page, "7");
      const first = await textOf(page, WHEEL);
      await page.keyboard.press("Control+z");
      assert.equal(await textOf(page, WHEEL), before);
      await page.keyboard.type("8"); // the editor's redo is gone
      const second = await textOf(page, WHEEL);
      await leaveEditor(page);
      const seen = [];
      for (let i = 0; i < 3; ++i) {
        await page.keyboard.press("Control+z");
        seen.push(await textOf(page, WHEEL));
      }
      assert.deepEqual(seen, [before, first, before]);
      for (let i = 0; i < 3; ++i) await page.keyboard.press("Control+y");
      assert.equal(await textOf(page, WHEEL), second);
    }),

  "what is typed into a large program is kept before anything is taken back": (places) =>
    withPage(places.studio, async (page) => {
      const long = `${"G1 X1\n".repeat(40_000)}M2\n`;
      await page.evaluate((text) => {
        const { session } = window.studio;
        session.history.edit("a long program", { documents: { "long.nc": text }, setup: { program: "long.nc" } });
      }, long);
      await page.locator("#code .cm-line").first().click();
      await page.keyboard.type("G4");
      const typed = await page.evaluate((name) => {
        const { session, documents } = window.studio;
        const early = documents.text(name).length;
        session.history.undo();
        session.history.redo();
        return [early, documents.text(name)];
      }, "long.nc");
      assert.equal(typed[0], long.length, "a long text is handed on when a person pauses");
      assert.equal(typed[1].length, long.length + 2);
    }),

  "the keys leave text fields and dialogs alone": (places) =>
    withPage(places.studio, async (page) => {
      await runAnew(page, () => machine(page).selectOption(LARGE));
      await page.locator("#bar summary").click();
      await page.getByLabel("Feed override, %").focus();
      await page.keyboard.press("Control+z");
      assert.equal((await setup(page)).machine, LARGE);
      await page.keyboard.press("Escape");
      await page.getByRole("button", { name: "Keys" }).click();
      await page.keyboard.press("Control+z");
      assert.equal((await setup(page)).machine, LARGE);
      await page.keyboard.press("Escape");
      await page.keyboard.press("Control+z");
      assert.equal((await setup(page)).machine, MEASURED);
    }),

  "opened files, a sample and Lua of one's own are taken back, too": (places) =>
    withPage(places.studio, async (page) => {
      const chooser = page.waitForEvent("filechooser");
      await page.locator("#open-button").click();
      const files = ["rosette.ngc", "machines/linuxcnc-router.toml"].map((name) => join(places.samples, name));
      await runAnew(page, async () => (await chooser).setFiles(files));
      await page.locator("#gallery-button").click();
      await runAnew(page, () => page.getByRole("button", { name: /A dome/ }).click());
      await page.getByRole("button", { name: "Lua", exact: true }).click();
      await page.getByRole("button", { name: "Edit Lua" }).click();
      assert.equal((await setup(page)).program, "samples/mill/dome.lua");
      const undo = async () => {
        await page.locator("#undo-button").click();
        const { program, machine, dialect } = await setup(page);
        return [program, machine, dialect, await page.evaluate(() => window.studio.documents.userFileNames().length)];
      };
      assert.deepEqual(await undo(), ["samples/mill/dome.nc", "samples/machines/mill-head-table.toml", "", 2]);
      assert.deepEqual(await undo(), ["rosette.ngc", "linuxcnc-router.toml", "rs274ngc", 2]);
      assert.deepEqual(await undo(), [WHEEL, MEASURED, "", 0]);
      // Its Lua is shown, when it is there.
      await page.waitForFunction(() => /WHEEL/.test(document.getElementById("code").innerText), null, { timeout: 10_000 });
      assert.equal(await page.locator("#undo-button").getAttribute("title"), "Nothing to undo (Ctrl+Z)");
    }),

  "a program that is typed into an empty page goes and comes": (places) =>
    withPage(places.studio, async (page) => {
      await page.evaluate(() => window.studio.session.change({ program: "" }));
      await editor(page).click();
      await page.keyboard.type("G0 X5");
      assert.equal((await setup(page)).program, "untitled.nc");
      await leaveEditor(page);
      await page.keyboard.press("Control+z");
      assert.equal((await setup(page)).program, "");
      assert.equal(await editor(page).innerText().then((text) => text.includes("G0 X5")), false);
      await page.keyboard.press("Control+y");
      assert.deepEqual([(await setup(page)).program, await textOf(page, "untitled.nc")], ["untitled.nc", "G0 X5"]);
    }),

  "the focus stays where it is when the bar follows": (places) =>
    withPage(places.studio, async (page) => {
      for (const name of ["Millimetres or inches", "Light or dark"]) {
        await page.getByRole("button", { name }).focus();
        await page.keyboard.press("Enter");
        assert.equal(await focused(page), name);
      }
      await machine(page).focus();
      await runAnew(page, () => machine(page).selectOption(LARGE));
      assert.equal(await focused(page), "Machine");
      await page.evaluate(() => window.studio.documents.put("new.nc", "G0 X1\nM2\n"));
      assert.equal(await focused(page), "Machine");
      assert.equal(await page.locator('option[value="new.nc"]').count(), 1);
      await page.evaluate((text) => {
        window.studio.documents.put("endless.lua", text);
        window.studio.session.change({ program: "endless.lua" });
      }, ENDLESS);
      await page.locator("#run-button").focus();
      await page.keyboard.press("Enter");
      await page.waitForFunction(() => window.studio.store.get("running")?.done > 0, null, { timeout: 20_000 });
      assert.equal(await focused(page), "cancel-button");
      await page.keyboard.press("Enter");
      assert.equal(await state(page, "running"), null);
      assert.equal(await focused(page), "run-button");
    }),

  "More closes by Escape and by a click elsewhere": (places) =>
    withPage(places.studio, async (page) => {
      const details = page.locator("#bar details");
      const isOpen = () => details.evaluate((element) => element.open);
      await page.locator("#bar summary").click();
      await page.getByLabel("Language").focus();
      await page.keyboard.press("Escape");
      assert.equal(await isOpen(), false);
      assert.equal(await page.evaluate(() => document.activeElement.tagName), "SUMMARY");
      await page.locator("#bar summary").click();
      await page.getByLabel("Feed override, %").click();
      assert.equal(await isOpen(), true);
      await page.locator("#side").click({ position: { x: 20, y: 450 } });
      assert.equal(await isOpen(), false);
    }),
};

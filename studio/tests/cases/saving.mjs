// Saving into the folder that gsim-studio serves, while a person types, presses keys twice, and other programs write.

import assert from "node:assert/strict";
import { readFileSync, rmSync } from "node:fs";
import { join } from "node:path";
import { hold, noticed, typeAfter, withServed } from "../served.mjs";

const PART = "G21 G90\nG1 X10 F600\nG1 X20\nM2\n";
/** The editor hands on what is typed here when a person pauses. */
const LONG = PART.replace("M2\n", `${`(${"-".repeat(998)})\n`.repeat(300)}M2\n`);

const textOf = (page, name) => page.evaluate((of) => window.studio.documents.text(of), name);
const markFor = (page, name) => page.evaluate((of) => window.studio.folder.markFor(of), name);
const displayed = (page) => page.locator("#code .cm-content").first().innerText();
const hasMark = (page, name, mark) =>
  page.waitForFunction(([of, expectedValue]) => window.studio.folder.markFor(of) === expectedValue, [name, mark], { timeout: 10_000 });

export default {
  "what is typed into a long program while it is saved stays, unsaved": (places) =>
    withServed(places, { "long.nc": LONG }, async (page, served) => {
      const put = await hold(page, "PUT", "long.nc");
      await typeAfter(page, "G1 X20", " F300");
      await page.keyboard.press("Control+s");
      await put.asked();
      await page.keyboard.type(" (more)");
      put.go();
      await noticed(page, "Saved: long.nc");
      assert.match(await displayed(page), /G1 X20 F300 \(more\)/);
      await hasMark(page, "long.nc", "unsaved");
      assert.equal(served.text("long.nc"), LONG.replace("X20", "X20 F300"));
      await page.keyboard.press("Control+s");
      await hasMark(page, "long.nc", "");
      assert.equal(served.text("long.nc"), LONG.replace("X20", "X20 F300 (more)"));
    }),

  "what is typed into a long program while another version of it is read makes two versions": (places) =>
    withServed(places, { "long.nc": LONG }, async (page, served) => {
      await typeAfter(page, "G1 X20", "");
      const get = await hold(page, "GET", "long.nc");
      served.write("long.nc", LONG.replace("X10", "X15"));
      await get.asked();
      await page.keyboard.type(" F300");
      get.go();
      await noticed(page, "long.nc was changed here and by another program");
      assert.match(await displayed(page), /G1 X10 F600\nG1 X20 F300/);
      assert.equal(await textOf(page, "long.nc"), LONG.replace("X20", "X20 F300"));
    }),

  "what is typed into a long program that is taken away stays": (places) =>
    withServed(places, { "long.nc": LONG, "part.nc": PART }, async (page, served) => {
      await typeAfter(page, "G1 X20", "");
      await page.keyboard.type(" F300");
      rmSync(served.path("long.nc"));
      let typed = " F300";
      // Without a pause, in which the editor would hand it on.
      for (; typed.length < 200 && (await markFor(page, "long.nc")) !== "gone"; typed += "1") await page.keyboard.type("1");
      await noticed(page, "long.nc is no longer in the folder");
      assert.ok((await displayed(page)).includes(`G1 X20${typed}\n`));
      await page.waitForFunction((end) => window.studio.documents.text("long.nc").includes(end), `G1 X20${typed}\n`);
    }),

  "what is typed into a long program is asked for before the page goes": (places) =>
    withServed(places, { "long.nc": LONG }, async (page) => {
      const isAskedFor = () => page.evaluate(() => !dispatchEvent(new Event("beforeunload", { cancelable: true })));
      assert.equal(await isAskedFor(), false);
      await typeAfter(page, "G1 X20", "1");
      assert.equal(await isAskedFor(), true);
    }),

  "a text that is on the disk as it is typed back is not said to be edited": (places) =>
    withServed(places, { "part.nc": PART }, async (page) => {
      const put = await hold(page, "PUT", "part.nc");
      await typeAfter(page, "G1 X20", " F300");
      await page.keyboard.press("Control+s");
      await put.asked();
      await page.keyboard.type("1");
      put.go();
      await noticed(page, "Saved: part.nc");
      const header = page.locator("#code .code-header");
      assert.match(await header.innerText(), /edited/);
      await page.keyboard.press("Backspace");
      assert.equal(await markFor(page, "part.nc"), "");
      assert.doesNotMatch(await header.innerText(), /edited/);
    }),

  "a key that is pressed twice saves twice, and one that is held once": (places) =>
    withServed(places, { "part.nc": PART }, async (page, served) => {
      const put = await hold(page, "PUT", "part.nc");
      await typeAfter(page, "G1 X20", " F300");
      await page.keyboard.press("Control+s");
      await put.asked();
      await page.keyboard.type("0");
      await page.keyboard.press("Control+s");
      put.go();
      await hasMark(page, "part.nc", "");
      assert.equal(await page.locator("dialog").count(), 0);
      assert.deepEqual([put.count, served.text("part.nc")], [2, PART.replace("X20", "X20 F3000")]);
      await page.keyboard.type("1");
      await page.keyboard.down("Control");
      for (let i = 0; i < 4; ++i) await page.keyboard.down("s");
      await page.keyboard.up("s");
      await page.keyboard.up("Control");
      await hasMark(page, "part.nc", "");
      await page.waitForTimeout(300);
      assert.equal(put.count, 3);
    }),

  "of two versions a person is asked once": (places) =>
    withServed(places, { "part.nc": PART }, async (page, served) => {
      await typeAfter(page, "G1 X20", " F300");
      served.write("part.nc", PART.replace("X10", "X15"));
      await hasMark(page, "part.nc", "conflict");
      const get = await hold(page, "GET", "part.nc");
      await page.keyboard.press("Control+s");
      await get.asked();
      await page.keyboard.press("Control+s");
      get.go();
      await page.locator("dialog").waitFor();
      await page.keyboard.press("Control+s");
      await page.waitForTimeout(300);
      assert.deepEqual([await page.locator("dialog").count(), get.count], [1, 1]);
      await page.locator("dialog").getByRole("button", { name: "Later" }).click();
      await page.waitForFunction(() => !document.querySelector("dialog"));
      await page.keyboard.press("Control+s");
      await page.locator("dialog").waitFor();
    }),

  "a new file that was saved, and whose making is undone, is opened from the folder": (places) =>
    withServed(places, { "part.nc": PART }, async (page, served) => {
      const text = PART.replace("X20", "X25");
      await page.evaluate((made) => {
        window.studio.session.history.edit("new", { documents: { "new.nc": made }, setup: { program: "new.nc" } });
      }, text);
      await page.waitForFunction(() => window.studio.store.get("document") === "new.nc");
      await page.locator("#save-button").click();
      await noticed(page, "Saved: new.nc");
      await page.locator("#undo-button").click();
      await page.waitForFunction(() => window.studio.store.get("document") === "part.nc");
      await page.locator("#bar label").first().locator("select").selectOption("new.nc");
      await page.waitForFunction(() => window.studio.store.get("run").report?.program === "new.nc", null, { timeout: 10_000 });
      await page.waitForFunction(() => /G1 X25/.test(document.getElementById("code").innerText));
      await typeAfter(page, "G1 X25", " F300");
      await page.keyboard.press("Control+s");
      await hasMark(page, "new.nc", "");
      assert.equal(served.text("new.nc"), text.replace("X25", "X25 F300"));
    }),

  "what is typed while a program is saved under its first name goes there, unsaved": (places) =>
    withServed(places, { "part.nc": PART }, async (page, served) => {
      await page.evaluate(() => window.studio.session.change({ program: "samples/wheel.nc" }));
      const put = await hold(page, "PUT", "mine.nc");
      await typeAfter(page, /^N210 /, "1");
      await page.keyboard.press("Control+s");
      await page.locator("dialog input").fill("mine.nc");
      await page.keyboard.press("Enter");
      await put.asked();
      await typeAfter(page, /^N210 /, "2");
      put.go();
      await page.waitForFunction(() => window.studio.session.setup.program === "mine.nc");
      assert.match(await textOf(page, "mine.nc"), /^N210 .*12$/m);
      assert.match(served.text("mine.nc"), /^N210 .*1$/m);
      assert.equal(await markFor(page, "mine.nc"), "unsaved");
      assert.match(await displayed(page), /N210 .*12\n/);
    }),

  "Save in the forms of machine, cell and paths saves into the folder": (places) => {
    const sample = (name) => readFileSync(join(places.samples, name), "latin1");
    const files = {
      "part.nc": PART,
      "router.toml": sample("machines/router3.toml"),
      "table.toml": sample("cell/table.toml"),
      "wheel.path.json": sample("wheel.path.json"),
    };
    return withServed(places, files, async (page, served) => {
      await page.evaluate(() => {
        window.studio.session.change({ machine: "router.toml", cell: "table.toml" });
        window.studio.store.set("pathFile", "wheel.path.json");
      });
      const side = page.locator("#side");
      const saves = async (name, form) => {
        await page.evaluate((of) => window.studio.documents.put(of, `${window.studio.documents.text(of)}\n`), name);
        await hasMark(page, name, "unsaved");
        await form.getByRole("button", { name: "Save", exact: true }).click();
        await noticed(page, `Saved: ${name}`);
        assert.equal(served.text(name), `${files[name]}\n`);
        assert.equal(await markFor(page, name), "");
      };
      const row = side.locator(".machine-form .file-row:visible");
      // The saved file is the one in the form.
      const shows = (name) => row.locator("b").filter({ hasText: name }).waitFor();
      await side.locator(".side-bar").getByRole("tab", { name: "Machine" }).click();
      await shows("router.toml");
      await saves("router.toml", row);
      await side.locator(".machine-form").getByRole("tab", { name: "Cell", exact: true }).click();
      await shows("table.toml");
      await saves("table.toml", row);
      await side.getByRole("tab", { name: "Paths", exact: true }).click();
      await saves("wheel.path.json", side.locator(".paths"));
    });
  },

  "Save in a form saves what was entered just before it": (places) => {
    const router = readFileSync(join(places.samples, "machines/router3.toml"), "latin1");
    return withServed(places, { "part.nc": PART, "router.toml": router }, async (page, served) => {
      await page.evaluate(() => window.studio.session.change({ machine: "router.toml" }));
      await page.locator("#side .side-bar").getByRole("tab", { name: "Machine" }).click();
      const form = page.locator("#side .machine-form");
      const card = form.locator("details.card:visible").filter({ has: page.locator('summary > b:text-is("X")') });
      await card.locator("summary").first().click();
      await card.getByLabel("Max speed", { exact: true }).locator("visible=true").fill("123");
      await form.locator(".file-row:visible").getByRole("button", { name: "Save", exact: true }).click();
      await noticed(page, "Saved: router.toml");
      assert.match(served.text("router.toml"), /max_speed_mm_s = 123/);
      assert.equal(await markFor(page, "router.toml"), "");
    });
  },

  "a file is not saved under the name of another one that is unsaved": (places) =>
    withServed(places, { "part.nc": PART }, async (page, served) => {
      await page.evaluate(() => {
        window.studio.documents.put("mine.nc", "G21\nM2\n");
        window.studio.session.change({ program: "samples/wheel.nc" });
      });
      await typeAfter(page, /^N210 /, "1");
      await page.keyboard.press("Control+s");
      await page.locator("dialog input").fill("mine.nc");
      await page.keyboard.press("Enter");
      await noticed(page, "mine.nc is not saved: a file with this name already exists");
      assert.equal(await textOf(page, "mine.nc"), "G21\nM2\n");
      assert.throws(() => served.text("mine.nc"), /ENOENT/);
    }),

  "what another program saves is taken back by a step of its own": (places) =>
    withServed(places, { "part.nc": PART }, async (page, served) => {
      await typeAfter(page, "G1 X20", " F300");
      await page.keyboard.press("Control+s");
      await hasMark(page, "part.nc", "");
      const theirs = PART.replace("X20", "X20 F300").replace("X10", "X15");
      served.write("part.nc", theirs);
      await noticed(page, "part.nc was changed by another program: run again");
      assert.match(await page.locator("#undo-button").getAttribute("title"), /^Undo: Use part\.nc from the disk/);
      await page.locator("#undo-button").click();
      assert.equal(await textOf(page, "part.nc"), PART.replace("X20", "X20 F300"));
      await page.locator("#redo-button").click();
      assert.equal(await textOf(page, "part.nc"), theirs);
      assert.equal(await markFor(page, "part.nc"), "");
    }),
};

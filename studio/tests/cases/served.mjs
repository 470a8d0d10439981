// The page that gsim-studio serves: files of a folder, saved and watched.

import assert from "node:assert/strict";
import { existsSync, readFileSync, rmSync } from "node:fs";
import { join } from "node:path";
import { noticed, typeAfter, withServed } from "../served.mjs";
import { state } from "../steps.mjs";

const ROUTER = 'name = "router"\n[[axis]]\nletter = "X"\nkind = "linear"\ndirection = [1.0, 0.0, 0.0]\n';
const PART = "G21 G90\r\nG1 X10 F600\r\nG1 X20\r\nM2 (Ende f\xfcr heute)\r\n";
const files = { "part.nc": PART, "notes.md": "nothing to run\n", "sub/other.nc": "G21 G90\nG1 X5 F100\nM2\n" };
const ENDLESS = "local _ENV = require 'gsim'\nprogram(1, function()\n  F(6000) while true do G1{x=100} G1{x=0} end\nend)\n";

const runOf = (page) => page.evaluate(() => window.studio.store.get("run")?.report);
const cycleTime = async (page) => (await runOf(page)).cycle_time_s;

/** Waits until a run takes another time than `before_s`. */
const ranAnew = (page, before_s) =>
  page.waitForFunction((time) => Math.abs(window.studio.store.get("run").report.cycle_time_s - time) > 1e-6, before_s, { timeout: 10_000 });

/** Another program has written the file while it was edited here. */
async function makeConflict(page, served) {
  await typeAfter(page, "G1 X20", " F300");
  served.write("part.nc", PART.replace("X10", "X15"));
  await noticed(page, "part.nc was changed here and by another program");
}

export default {
  "the holes of a part that is bent become a path, by which the jet follows their walls": (places) => {
    if (!existsSync(join(places.build, "bin/gsim-solid"))) return console.log("  skipped: there is no OpenCASCADE here");
    const step = readFileSync(join(places.samples, "parts/bracket.step"), "latin1");
    return withServed(places, { "part.nc": PART, "bracket.step": step }, async (page) => {
      const side = page.locator("#side");
      await side.getByRole("tab", { name: "Paths", exact: true }).click();
      await side.getByRole("button", { name: "From drawing…" }).click();
      const dialog = page.getByRole("dialog", { name: "Path from drawing" });
      await dialog.getByLabel("Drawing").selectOption("bracket.step");
      await dialog.getByLabel("Speed, mm/min").fill("400");
      await dialog.getByLabel("Kerf, mm").fill("0.8");
      assert.equal(await dialog.getByText("flipped").isVisible(), true);
      await dialog.getByLabel("Cut", { exact: true }).selectOption("holes");
      assert.equal(await dialog.getByText("flipped").isVisible(), false);
      for (const [letter, value] of Object.entries({ X: 600, Y: 600, Z: 120 })) await dialog.getByLabel(`Origin at ${letter}`).fill(String(value));
      // A hole is tapered, by 12 degrees.
      await dialog.getByLabel("Max tilt").fill("5");
      await dialog.getByRole("button", { name: "Make path" }).click();
      await dialog.getByRole("alert").filter({ hasText: "more than 5 deg (--max-tilt)" }).waitFor();
      await dialog.getByLabel("Max tilt").fill("60");
      await dialog.getByRole("button", { name: "Make path" }).click();
      await dialog.waitFor({ state: "detached" });
      await side.getByText(/4 contours, 4 pierces/).waitFor();
      const axes = await page.evaluate(() => window.studio.store.get("path").file.paths.flatMap(({ targets }) => targets.flatMap((each) => each.tool_axis ?? [])));
      assert.ok(axes.length > 0 && axes.some((value) => Math.abs(value) > 0.1 && Math.abs(value) < 0.9));
    });
  },

  "a served folder is listed, and its first program runs": (places) =>
    withServed(places, { ...files, "machine.toml": ROUTER }, async (page) => {
      assert.equal((await runOf(page)).program, "part.nc");
      await page.waitForFunction(() => document.querySelector('#bar option[value="machine.toml"]'));
      const programs = await page.locator("#bar label").first().locator("option").allInnerTexts();
      assert.deepEqual(programs.slice(0, 2), ["part.nc", "sub/other.nc"]);
      assert.ok(!programs.includes("notes.md"));
      assert.match(await page.locator("#code").innerText(), /Ende für heute/);
      await page.waitForFunction(() => /Ende für heute|No problems/.test(document.getElementById("code").innerText));
    }),

  "an edit is marked, saved as bytes of the file's own kind, and marked no more": (places) =>
    withServed(places, files, async (page, served) => {
      const before_s = await cycleTime(page);
      await typeAfter(page, "G1 X20", " F300");
      const option = page.locator('#bar option[value="part.nc"]').first();
      await page.waitForFunction(() => document.querySelector('#bar option[value="part.nc"]').textContent === "part.nc ●");
      assert.match(await page.locator("#code .code-header").innerText(), /edited/);
      assert.equal(served.text("part.nc"), PART);
      await page.keyboard.press("Control+Enter");
      await ranAnew(page, before_s);
      assert.equal(served.text("part.nc"), PART, "running saves nothing");
      await page.keyboard.press("Control+s");
      await noticed(page, "Saved: part.nc");
      assert.equal(served.text("part.nc"), PART.replace("X20", "X20 F300"));
      assert.equal(await option.textContent(), "part.nc");
      assert.ok(await page.locator("#save-button").isDisabled());
      assert.ok(!/edited/.test(await page.locator("#code .code-header").innerText()));
    }),

  "save all saves what is new, too, and asks for the name of what has none": (places) =>
    withServed(places, files, async (page, served) => {
      await page.evaluate(() => {
        const { documents } = window.studio;
        documents.put("part.nc", documents.text("part.nc").replace("X20", "X25"));
        documents.put("new/made.toml", "a = 1\n");
        documents.put("samples/wheel.nc", "G21\nM2\n");
      });
      await page.locator("#save-all-button").click();
      const dialog = page.locator("dialog");
      assert.equal(await dialog.locator("input").inputValue(), "wheel.nc");
      await dialog.locator("input").fill("../wheel.nc");
      await page.keyboard.press("Enter");
      assert.match(await dialog.innerText(), /must not contain \.\./);
      await dialog.locator("input").fill("my wheel & all.nc");
      await page.keyboard.press("Enter");
      await noticed(page, "Saved: ");
      assert.equal(served.text("part.nc"), PART.replace("X20", "X25"));
      assert.equal(served.text("new/made.toml"), "a = 1\n");
      assert.equal(served.text("my wheel & all.nc"), "G21\nM2\n");
      const { own, fileMarks } = await page.evaluate(() => ({
        own: window.studio.documents.isUserFile("samples/wheel.nc"),
        fileMarks: window.studio.folder.fileMarks().size,
      }));
      assert.deepEqual([own, fileMarks], [false, 0], "the sample is as it was");
    }),

  "what another editor saves is shown and run": (places) =>
    withServed(places, files, async (page, served) => {
      const before_s = await cycleTime(page);
      served.write("part.nc", PART.replace("X20", "X200"));
      await ranAnew(page, before_s);
      await noticed(page, "part.nc was changed by another program: run again");
      assert.match(await page.locator("#code").innerText(), /X200/);
      assert.ok(await page.locator("#save-button").isDisabled());
    }),

  // A browser has six connections to a server, for all its pages together.
  "eight tabs of one folder save, and each sees what another program saves": (places) =>
    withServed(places, files, async (page, served) => {
      const tabs = [page];
      while (tabs.length < 8) {
        const tab = await page.context().newPage();
        await tab.goto(page.url());
        await tab.waitForFunction(() => window.studio?.store.get("run")?.report, null, { timeout: 60_000 });
        tabs.push(tab);
      }
      const seen = (tab, text) =>
        tab.waitForFunction((words) => window.studio.documents.text("part.nc")?.includes(words), text, { timeout: 30_000, polling: 200 });
      const saved = await tabs.at(-1).evaluate(() => {
        const { documents, folder } = window.studio;
        documents.put("part.nc", documents.text("part.nc").replace("X20", "X25"));
        return folder.save("part.nc");
      });
      assert.deepEqual(saved, { kind: "saved" });
      await Promise.all(tabs.map((tab) => seen(tab, "X25")));
      await tabs[3].close();
      served.write("part.nc", PART.replace("X20", "X30"));
      await Promise.all(tabs.filter((tab) => !tab.isClosed()).map((tab) => seen(tab, "X30")));
    }),

  "of two versions mine may be kept, and theirs comes back by undo": (places) =>
    withServed(places, files, async (page, served) => {
      await makeConflict(page, served);
      await page.waitForFunction(() => document.querySelector('#bar option[value="part.nc"]').textContent === "part.nc ⚠");
      await page.locator("#save-button").click();
      const dialog = page.locator("dialog");
      assert.match(await dialog.innerText(), /First difference at line 2[^]*G1 X10 F600[^]*G1 X15 F600/);
      await dialog.getByRole("button", { name: "Keep this page's version" }).click();
      await noticed(page, "Saved: part.nc");
      assert.equal(served.text("part.nc"), PART.replace("X20", "X20 F300"));
      await page.evaluate(() => window.studio.session.history.undo());
      assert.match(await page.evaluate(() => window.studio.documents.text("part.nc")), /X15/);
    }),

  "of two versions theirs may be taken, and mine comes back by undo": (places) =>
    withServed(places, files, async (page, served) => {
      await makeConflict(page, served);
      await page.getByRole("button", { name: "Decide…" }).click();
      await page.locator("dialog").getByRole("button", { name: "Use the version on disk" }).click();
      await page.waitForFunction(() => /G1 X15/.test(document.getElementById("code").innerText));
      assert.equal(await page.evaluate(() => window.studio.folder.fileMarks().size), 0);
      await page.evaluate(() => window.studio.session.history.undo());
      assert.match(await page.evaluate(() => window.studio.documents.text("part.nc")), /X20 F300/);
      assert.equal(served.text("part.nc"), PART.replace("X10", "X15"));
    }),

  "of two versions mine may be saved under another name": (places) =>
    withServed(places, files, async (page, served) => {
      await makeConflict(page, served);
      await page.getByRole("button", { name: "Decide…" }).click();
      await page.locator("dialog").getByRole("button", { name: "Save mine under another name" }).click();
      assert.equal(await page.locator("dialog input").inputValue(), "part-2.nc");
      await page.keyboard.press("Enter");
      await page.waitForFunction(() => window.studio.session.setup.program === "part-2.nc");
      await page.waitForFunction(() => /X15/.test(window.studio.documents.text("part.nc")));
      assert.equal(served.text("part-2.nc"), PART.replace("X20", "X20 F300"));
      assert.equal(served.text("part.nc"), PART.replace("X10", "X15"));
      assert.equal(await page.evaluate(() => window.studio.folder.fileMarks().size), 0);
    }),

  "a version that this page has not heard of is not written over": (places) =>
    withServed(
      places,
      files,
      async (page, served) => {
        await typeAfter(page, "G1 X20", " F300");
        served.write("part.nc", PART.replace("X10", "X15"));
        await page.keyboard.press("Control+s");
        await page.locator("dialog").getByRole("button", { name: "Later" }).click();
        await noticed(page, "part.nc was changed here and by another program");
        assert.equal(served.text("part.nc"), PART.replace("X10", "X15"));
        assert.match(await page.evaluate(() => window.studio.documents.text("part.nc")), /X20 F300/);
      },
      { expected: /412/ },
    ),

  "a file that was dropped is saved into the folder": (places) =>
    withServed(places, files, async (page, served) => {
      const chooser = page.waitForEvent("filechooser");
      await page.locator("#open-button").click();
      await (await chooser).setFiles({ name: "far.nc", mimeType: "text/plain", buffer: Buffer.from(PART, "latin1") });
      await page.waitForFunction(() => window.studio.store.get("run").report?.program === "far.nc");
      await page.locator("#save-button").click();
      await noticed(page, "Saved: far.nc");
      assert.equal(served.text("far.nc"), PART);
    }),

  "a file that is taken away stays in the page, and is saved again": (places) =>
    withServed(places, files, async (page, served) => {
      rmSync(served.path("part.nc"));
      await noticed(page, "part.nc is no longer in the folder");
      assert.match(await page.locator("#code").innerText(), /Ende für heute/);
      await page.getByRole("button", { name: "Save it again" }).click();
      await page.waitForFunction(() => window.studio.folder.fileMarks().size === 0);
      assert.equal(served.text("part.nc"), PART);
    }),

  "a program that is too large to show is run all the same": (places) => {
    const long = `G21 G90\n${`(${"-".repeat(998)})\n`.repeat(66_000)}G1 X10 F600\nM2\n`;
    return withServed(places, { ...files, "sub/long.nc": long }, async (page, served) => {
      await page.locator("#bar label").first().locator("select").selectOption("sub/long.nc");
      await page.waitForFunction(() => window.studio.store.get("run").report?.program === "sub/long.nc", null, { timeout: 60_000 });
      assert.ok(Math.abs((await cycleTime(page)) - 1) < 0.5);
      assert.match(await page.locator("#code").innerText(), /too large to show here \(66 MB\)[^]*Not checked/);
      assert.equal(await page.evaluate(() => window.studio.documents.get("sub/long.nc")), undefined);
      served.write("sub/long.nc", long.replace("X10", "X20"));
      await ranAnew(page, await cycleTime(page));
    });
  },

  "an endless program is cancelled at once, and the server goes on": (places) =>
    withServed(places, { ...files, "sub/endless.lua": ENDLESS }, async (page) => {
      await page.evaluate(() => {
        window.studio.session.change({ program: "sub/endless.lua" });
        void window.studio.session.run();
      });
      await page.waitForFunction(() => window.studio.store.get("running")?.done > 0, null, { timeout: 20_000 });
      await page.locator("#cancel-button").click();
      const began = performance.now();
      const time_s = await page.evaluate(async () => {
        const { session, store } = window.studio;
        session.change({ program: "part.nc" });
        await session.run();
        return store.get("run").report.cycle_time_s;
      });
      console.log(`  cancelled and run anew in ${(performance.now() - began).toFixed(0)} ms`);
      assert.ok(time_s > 0 && performance.now() - began < 5000);
    }),

  "that the server has ended is said, and documents are still to be had": (places) =>
    withServed(places, files, async (page, served) => {
      await typeAfter(page, "G1 X20", " F300");
      await served.end();
      await noticed(page, "gsim-studio has ended");
      const { error } = await page.evaluate(async () => {
        await window.studio.session.run();
        return window.studio.store.get("run");
      });
      assert.match(error.message, /does not respond/);
      await noticed(page, "gsim-studio has ended");
      const downloading = page.waitForEvent("download");
      await page.locator("#save-button").click();
      const stream = await (await downloading).createReadStream();
      const bytes = Buffer.concat(await stream.toArray()).toString("latin1");
      assert.equal(bytes, PART.replace("X20", "X20 F300"));
      assert.equal(await state(page, "document"), "part.nc");
    }, { expected: /Failed to load resource/ }),
};

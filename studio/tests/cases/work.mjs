// Actions of a user in the page.

import assert from "node:assert/strict";
import { join } from "node:path";
import { difference, dropFiles, pictureOfView, run, setState, untilSettled, state, withPage } from "../steps.mjs";

const ENDLESS = "local _ENV = require 'gsim'\nprogram(1, function()\n  F(6000) while true do G1{x=100} G1{x=0} end\nend)\n";

/**
 * Places the cursor in a line of the program, by a click on its text; on a busy machine that may still be
 * scrolling into view.
 */
async function clickLine(page, line) {
  await page.evaluate((number) => window.studio.store.set("selection", { file: "samples/wheel.nc", line: number, block: -1 }), line);
  await page.waitForTimeout(300);
  await setState(page, "selection", null);
  for (let attempt = 0; attempt < 5; ++attempt) {
    await page.locator("#code .cm-line").filter({ hasText: /^N470 / }).first().click();
    const there = page.waitForFunction((number) => window.studio.store.get("selection")?.line === number, line, { timeout: 5_000 });
    if (await there.then(() => true, () => false)) return;
  }
}

export default {
  "a click on a line goes to its time, and shows it on the way": (places) =>
    withPage(places.studio, async (page) => {
      await untilSettled(page);
      const before = await pictureOfView(page);
      await clickLine(page, 38);
      await page.waitForFunction(() => window.studio.store.get("selection")?.line === 38);
      const time_s = await state(page, "time_s");
      const places38 = await page.evaluate((t) => window.studio.store.get("run").locationsAt(0, t + 1e-6), time_s);
      assert.equal(places38[0].line, 38);
      assert.ok((await difference(page, before, await pictureOfView(page))) > 0.001);
    }),

  "a click on the way goes to its line": (places) =>
    withPage(places.studio, async (page) => {
      await untilSettled(page);
      const point = await page.evaluate(() => {
        const { store, view } = window.studio;
        const { segments } = store.get("run").robots[0];
        const section = segments.sectionOf(20);
        const vertex = section.firstVertex(20);
        return { line: segments.lineOf(20).line, at: view.screenPosition([...section.vertex_mm.subarray(3 * vertex, 3 * vertex + 3)]) };
      });
      await page.mouse.click(point.at[0], point.at[1]);
      await page.waitForFunction(() => window.studio.store.get("selection") !== null);
      const { line } = await state(page, "selection");
      assert.ok(Math.abs(line - point.line) <= 1, `line ${line}, not ${point.line}`);
    }),

  "a broken line is underlined, and said in words": (places) =>
    withPage(places.studio, async (page) => {
      await clickLine(page, 38);
      await page.keyboard.press("End");
      await page.keyboard.type(" G999");
      await page.waitForFunction(() => /1 error/.test(document.getElementById("code").innerText), null, { timeout: 10_000 });
      assert.ok((await page.locator("#code .cm-lintRange-error").count()) > 0);
    }),

  "an endless program is cancelled, and the page goes on": (places) =>
    withPage(places.studio, async (page) => {
      await page.evaluate((text) => {
        const { session, documents } = window.studio;
        documents.put("endless.lua", text);
        session.change({ program: "endless.lua" });
        void session.run();
      }, ENDLESS);
      await page.waitForTimeout(1500);
      assert.notEqual(await state(page, "running"), null);
      await page.locator("#cancel-button").click();
      assert.equal(await state(page, "running"), null);
      const { status } = await run(page, { program: "samples/wheel.nc", machine: "samples/machines/af5-measured.toml" });
      assert.equal(status, "completed");
    }),

  "an endless script without motion ends by itself": (places) =>
    withPage(places.studio, async (page) => {
      const text = "local _ENV = require 'gsim'\nprogram(1, function() while true do end end)\n";
      const { status } = await run(page, { program: "endless.lua" }, { "endless.lua": text });
      assert.equal(status, "stopped");
    }),

  "a feed that is changed shows in the comparison, by block": (places) =>
    withPage(places.studio, async (page) => {
      await page.evaluate(async () => {
        const { session, documents } = window.studio;
        const name = "samples/wheel.nc";
        documents.put(name, documents.text(name).replace("C0 F6350", "C0 F3000"));
        await session.run();
      });
      await page.getByRole("tab", { name: "Compare" }).click();
      const text = await page.locator("#side").innerText();
      assert.match(text, /2:09\.989/);
    }),

  "files are opened by the dialog, each where it belongs": (places) =>
    withPage(places.studio, async (page) => {
      const chooser = page.waitForEvent("filechooser");
      await page.locator("#open-button").click();
      await (await chooser).setFiles([join(places.samples, "rosette.ngc"), join(places.samples, "machines/linuxcnc-router.toml")]);
      await page.waitForFunction(() => window.studio.store.get("run")?.report?.program === "rosette.ngc", null, { timeout: 20_000 });
      const { program, machine, dialect } = await page.evaluate(() => ({ ...window.studio.session.setup }));
      assert.deepEqual([program, machine, dialect], ["rosette.ngc", "linuxcnc-router.toml", "rs274ngc"]);
      assert.equal((await page.evaluate(() => window.studio.store.get("run").report)).status, "completed");
    }),

  "files dropped on a page from a disk are opened": (places) =>
    withPage(places.studio, async (page) => {
      await dropFiles(page, join(places.samples, "cell/clamp.nc"), join(places.samples, "cell/mould.stl"));
      await page.waitForFunction(() => window.studio.store.get("run")?.report?.program === "clamp.nc", null, { timeout: 20_000 });
      assert.match(await page.locator("#bar .notice").innerText(), /Also opened: mould\.stl/);
    }),

  "a file of no use is said to be": (places) =>
    withPage(places.studio, async (page) => {
      const chooser = page.waitForEvent("filechooser");
      await page.locator("#open-button").click();
      await (await chooser).setFiles({ name: "picture.png", mimeType: "image/png", buffer: Buffer.from([0x89, 0x50, 0, 1]) });
      await page.waitForFunction(() => window.studio.store.get("notice") !== "");
      assert.match(await page.locator("#bar .notice").innerText(), /Not a program.*picture\.png/);
    }),

  "a cancelled run says whose results are shown": (places) =>
    withPage(places.studio, async (page) => {
      await page.evaluate((text) => {
        const { session, documents } = window.studio;
        documents.put("endless.lua", text);
        session.change({ program: "endless.lua" });
        void session.run();
      }, ENDLESS);
      await page.waitForFunction(() => window.studio.store.get("running")?.done > 0, null, { timeout: 20_000 });
      await page.locator("#cancel-button").click();
      assert.match(await page.locator("#bar .notice").innerText(), /Cancelled.*samples\/wheel\.nc/);
    }),

  "a file that is no program is refused in words": (places) =>
    withPage(places.studio, async (page) => {
      const { error } = await run(page, { program: "nonsense.nc" }, { "nonsense.nc": "\u0000\u0001 what is this" });
      assert.ok(error);
      assert.match(await page.locator("#side").innerText(), /not run/);
    }),

  "space plays and stops, the period steps": (places) =>
    withPage(places.studio, async (page) => {
      await page.locator("#view .surface").focus();
      await page.keyboard.press("Home");
      await page.keyboard.press("Space");
      await page.waitForFunction(() => window.studio.store.get("time_s") > 0.3);
      await page.keyboard.press("Space");
      const stopped_s = await state(page, "time_s");
      await page.waitForTimeout(200);
      assert.equal(await state(page, "time_s"), stopped_s);
      await page.keyboard.press(".");
      assert.ok((await state(page, "time_s")) > stopped_s);
    }),

  "an edit of the wheel is seen within a second": (places) =>
    withPage(places.studio, async (page) => {
      await untilSettled(page);
      const elapsed_ms = await page.evaluate(async () => {
        const { session, documents, store } = window.studio;
        const began = performance.now();
        const name = "samples/wheel.nc";
        documents.put(name, documents.text(name).replace("C0 F6350", "C0 F5000"));
        await session.run();
        await new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
        return store.get("run").report.status === "completed" ? performance.now() - began : Infinity;
      });
      console.log(`  edit of the wheel to its new picture: ${elapsed_ms.toFixed(0)} ms`);
      assert.ok(Number.isFinite(elapsed_ms));
    }),
};

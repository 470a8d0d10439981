// A million blocks. Times are printed and recorded in bench/RESULTS.md; they never fail the test.

import assert from "node:assert/strict";
import { memoryOfBrowser } from "../memory.mjs";
import { untilSettled, withPage } from "../steps.mjs";

const GIGABYTE = 1e9;

const frames = (page, count, turn) =>
  page.evaluate(
    async ([number, what]) => {
      const { store, view } = window.studio;
      const times = [];
      for (let i = 0; i < number; ++i) {
        const began = performance.now();
        if (what === "orbit") view.orbit(6, 1);
        else store.set("time_s", store.get("time_s") + 0.05);
        await new Promise((done) => requestAnimationFrame(() => setTimeout(done)));
        times.push(performance.now() - began);
      }
      times.sort((a, b) => a - b);
      return { median_ms: times[number >> 1], worst_ms: times[number - 1], own_ms: view.measureFrame_ms(what), empty_ms: view.measureFrame_ms("empty") };
    },
    [count, turn],
  );

const rounded = (numbers) => JSON.stringify(numbers, (_, value) => (typeof value === "number" ? Math.round(10 * value) / 10 : value));

export default {
  "a million blocks are run, drawn, turned and scrubbed": (places) =>
    withPage(places.studio, async (page) => {
      const ran = await page.evaluate(async () => {
        const { session, documents, store } = window.studio;
        let seed = 12345;
        const next = () => (seed = (seed * 1103515245 + 12345) % 2147483648) / 2147483648;
        const lines = ["G21 G90 G17 G1 F3000\n"];
        let [x, y] = [900, 1200];
        for (let i = 0; i < 1_000_000; ++i) {
          x = Math.min(1800, Math.max(10, x + 4 * next() - 2));
          y = Math.min(2400, Math.max(10, y + 4 * next() - 2));
          lines.push(`X${x.toFixed(3)} Y${y.toFixed(3)}\n`);
        }
        documents.put("million.nc", lines.join(""));
        session.change({ program: "million.nc", machine: "samples/machines/af5.toml" });
        const began = performance.now();
        await session.run();
        const { report } = store.get("run");
        return { ms: performance.now() - began, blocks: report.blocks, segments: store.get("run").robots[0].segments.count };
      });
      const behind = performance.now();
      await page.waitForFunction(() => window.studio.view.complete(), null, { timeout: 60_000 });
      const drawn_ms = performance.now() - behind;
      assert.equal(ran.segments, 1_000_000);
      console.log(`  run ${(ran.ms / 1000).toFixed(1)} s, whole picture ${(drawn_ms / 1000).toFixed(1)} s behind its end`);
      console.log(`  turning: ${rounded(await frames(page, 15, "orbit"))}`);
      await untilSettled(page);
      console.log(`  machine before the resting way: ${rounded(await frames(page, 30, "rest"))}`);
      const memory = memoryOfBrowser();
      console.log(`  the page's process: ${(memory / 1e6).toFixed(0)} MB`);
      assert.ok(memory > 0 && memory < GIGABYTE, `${memory} bytes`);
    }),
};

// Runs that are too long for the page to hold: gsim-studio keeps them, the page fetches the shown parts. A
// page requests a million complete segments; here it requests fewer.

import assert from "node:assert/strict";
import { withServed } from "../served.mjs";
import { untilSettled, state } from "../steps.mjs";

const SHORT = "G21 G90\nG1 X10 F600\nM2\n";
const WHOLE = 16_384;
const LINES = 300_000;
const PATIENCE = { timeout: 60_000 };
const ENDLESS = "local _ENV = require 'gsim'\nprogram(1, function()\n  F(6000) while true do G1{x=100} G1{x=0} end\nend)\n";

/** Passes to and fro over a square of 60 mm, and at the end once round a larger one. */
function longProgram() {
  const lines = ["G21 G90 F6000\n"];
  for (let i = 0; i < LINES; ++i) {
    const [row, at] = [Math.floor(i / 600), i % 600];
    const x = (row % 2 ? 599 - at : at) / 10;
    lines.push(`G1 X${x.toFixed(2)} Y${((row * 0.13) % 60).toFixed(2)} Z${(Math.sin(i / 40) - 1).toFixed(3)}\n`);
  }
  lines.push("G0 Z5\nG0 X-40 Y-40\nG1 X100\nG1 Y100\nG1 X-40\nG1 Y-40\nM2\n");
  return lines.join("");
}

const files = { "part.nc": SHORT, "sub/long.nc": longProgram(), "sub/endless.lua": ENDLESS };

/** Makes the page request so few complete segments; returns the names of kept runs, as they come. */
async function askForFew(page) {
  const names = [];
  await page.route("**/ask", (route) => {
    const headers = route.request().headers();
    if (headers.run) names.push(headers.run);
    return route.continue({ headers: headers.whole ? { ...headers, whole: String(WHOLE) } : headers });
  });
  return names;
}

const runProgram = (page, program) =>
  page.evaluate(async (name) => {
    const { session, store } = window.studio;
    session.change({ program: name });
    await session.run();
    const run = store.get("run");
    const [{ segments }] = run.robots;
    return { end_s: run.end_s, count: segments.count, isLong: run.isLong, sections: segments.sections.length, error: run.error };
  }, program);

/**
 * Shows instants one by one, waits until the joints of each are loaded, and returns the axes, the lines, and
 * the time that it took.
 */
const scrubbed = (page, instants_s) =>
  page.evaluate(async (all) => {
    const { store } = window.studio;
    const run = store.get("run");
    const [robot] = run.robots;
    const found = [];
    for (const t_s of all) {
      const began = performance.now();
      store.set("time_s", t_s);
      while (!robot.joints_at(t_s)) await new Promise((done) => setTimeout(done, 1));
      found.push({ axes: robot.axes_at(t_s), places: run.locationsAt(0, t_s), kept: run.laws?.count ?? 0, ms: performance.now() - began });
    }
    return found;
  }, instants_s);

const inEach = (count, end_s) => Array.from({ length: count }, (_, i) => ((i + 0.37) / count) * end_s);
const noticed = (page, text) => page.waitForFunction((words) => document.getElementById("bar").innerText.includes(words), text, PATIENCE);

/**
 * Checks that axes and lines at instants are those of the complete run, and that no more data is kept than
 * should be.
 */
async function scrubsAs(page, instants_s, expectedValue) {
  const found = await scrubbed(page, instants_s);
  for (const [i, { axes, places }] of found.entries()) {
    assert.deepEqual([axes, places], [expectedValue[i].axes, expectedValue[i].places], `at ${instants_s[i]} s`);
  }
  assert.equal(Math.max(...found.map(({ kept }) => kept)), 16, "as many as are kept");
  const times = found.map(({ ms }) => ms).filter((ms) => ms > 5).sort((a, b) => a - b);
  console.log(`  joints that are fetched are here in ${times[times.length >> 1].toFixed(0)} ms in the median, ${times.at(-1).toFixed(0)} at most`);
}

/** A click on the middle of the third side of the square about all the others. */
async function clickOnWay(page) {
  await untilSettled(page);
  const [x, y] = await page.evaluate(() => window.studio.view.screenPosition([30, 100, 5]));
  await page.mouse.click(x, y);
  await page.waitForFunction(() => window.studio.store.get("selection") !== null, null, PATIENCE);
  assert.equal((await state(page, "selection")).line, LINES + 6);
  const axes = await page.waitForFunction(() => window.studio.store.get("run").robots[0].axes_at(window.studio.store.get("time_s")), null, PATIENCE);
  const [x_mm, y_mm] = await axes.jsonValue();
  assert.ok(Math.abs(x_mm - 30) < 4 && Math.abs(y_mm - 100) < 1e-6, `${x_mm}, ${y_mm}`);
}

/** The cursor on a line brings its start, exactly. */
async function goToLine(page, line) {
  await untilSettled(page);
  await page.evaluate((above) => window.studio.store.set("requestedLocation", { file: "sub/long.nc", line: above }), line - 1);
  await page.locator("#code .code-place").filter({ hasText: `${line - 1} :` }).waitFor();
  await page.keyboard.press("ArrowDown");
  await page.waitForFunction((expectedValue) => window.studio.store.get("selection")?.line === expectedValue, line, PATIENCE);
  const displayed = await page.waitForFunction(() => {
    const { store } = window.studio;
    const [{ segments }] = store.get("run").robots;
    const info = segments.info(segments.at(store.get("time_s")));
    return info && Math.abs(info.start_s - store.get("time_s")) < 1e-9 && info.line;
  }, null, PATIENCE);
  assert.equal(await displayed.jsonValue(), line);
}

/**
 * Checks that the page reports unknown data of lines, in place of heat and of facts next to the word at the
 * cursor.
 */
async function saysWhatIsLacking(page) {
  assert.match(await page.locator("#code .code-status").innerText(), /No line times: a long run/);
  await page.keyboard.press("Control+i");
  await page.locator(".code-hover").filter({ hasText: "the time of this line is not available" }).waitFor(PATIENCE);
  await page.keyboard.press("Escape");
}

/** Checks that the path is still shown without laws. */
async function goesOnByVertices(page) {
  const t_s = await page.evaluate(() => {
    const [{ segments }] = window.studio.store.get("run").robots;
    return segments.sections.find(({ first }) => !segments.locate(first)).start_s + 1;
  });
  await page.evaluate((at_s) => window.studio.store.set("time_s", at_s), t_s);
  await noticed(page, "Joints and charts are not available here");
  const displayed = await page.evaluate((at_s) => {
    const run = window.studio.store.get("run");
    const [{ segments }] = run.robots;
    return { joints: segments.joints_at(at_s), tip_mm: segments.tip_mm(at_s), place: run.locationsAt(0, at_s)[0] };
  }, t_s);
  assert.equal(displayed.joints, null);
  const said = page.locator("#time .feed");
  assert.deepEqual([await said.innerText(), await said.getAttribute("title")], ["…", "The current move is still being loaded, or is not available"]);
  assert.ok(displayed.tip_mm.every(Number.isFinite) && displayed.place.line > 1000, JSON.stringify(displayed));
  await untilSettled(page);
  await page.keyboard.press("Home");
  assert.ok(await page.evaluate(() => window.studio.store.get("run").robots[0].joints_at(0.1)), "the first of it is here for good");
}

export default {
  "a long run that the server keeps is as exact as a whole one, and keeps its way where the server ends": (places) =>
    withServed(
      places,
      files,
      async (page, served) => {
        const whole = await runProgram(page, "sub/long.nc");
        assert.deepEqual([whole.count, whole.isLong, whole.error], [LINES + 6, false, null]);
        const instants_s = [...inEach(30, whole.end_s), ...inEach(7, whole.end_s).reverse(), whole.end_s];
        const expectedValue = await scrubbed(page, instants_s);
        await askForFew(page);
        const long = await runProgram(page, "sub/long.nc");
        assert.deepEqual({ ...long, isLong: false }, whole);
        assert.equal(long.isLong, true);
        assert.equal(await state(page, "previous"), null, "a long run is not compared");
        await scrubsAs(page, instants_s, expectedValue);
        await clickOnWay(page);
        await goToLine(page, 200_001);
        await saysWhatIsLacking(page);
        await served.end();
        await goesOnByVertices(page);
      },
      { expected: /Failed to load resource/ },
    ),

  "a long run is shown while it grows, and of one that is cancelled nothing is left": (places) =>
    withServed(places, files, async (page) => {
      const names = await askForFew(page);
      await page.evaluate(() => {
        window.studio.session.change({ program: "sub/endless.lua" });
        void window.studio.session.run();
      });
      await page.waitForFunction(() => window.studio.store.get("partialRun")?.count > 100_000, null, PATIENCE);
      const laws = (name) =>
        page.evaluate(async (run) => {
          const response = await fetch(`laws/${run}/0`);
          await response.arrayBuffer(); // a browser has few connections for one address
          return response.status;
        }, name);
      assert.equal(await laws(names[0]), 200);
      await page.locator("#cancel-button").click();
      const left = await page.evaluate(() => {
        const { store } = window.studio;
        return [store.get("partialRun"), store.get("run").report.program, store.get("run").isLong];
      });
      assert.deepEqual(left, [null, "part.nc", false]);
      let status = 200;
      for (let i = 0; i < 100 && status === 200; ++i) {
        await page.waitForTimeout(50);
        status = await laws(names[0]);
      }
      assert.equal(status, 404);
      // A long run is dropped as soon as the next one is long.
      assert.equal((await runProgram(page, "sub/long.nc")).isLong, true);
      await page.evaluate(() => {
        window.studio.session.change({ program: "sub/endless.lua" });
        void window.studio.session.run();
      });
      await page.waitForFunction(() => window.studio.store.get("partialRun"), null, PATIENCE);
      assert.equal(await state(page, "run"), null);
      await page.locator("#cancel-button").click();
      assert.deepEqual([await state(page, "run"), await state(page, "partialRun")], [null, null]);
      assert.equal((await runProgram(page, "part.nc")).count, 1);
    }, { expected: /404/ }),
};

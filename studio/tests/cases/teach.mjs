// Joint panel: joints and TCP moved by hand, limits and contacts reported, points recorded, approached, and
// run.

import assert from "node:assert/strict";
import { join } from "node:path";
import { difference, pictureOfView, run, setState, untilSettled, state, withPage } from "../steps.mjs";

const docs = (places) => join(places.samples, "../docs/images");
const form = (page) => page.locator("#side .teach");
const tab = (page, name) => page.locator("#side").getByRole("tab", { name, exact: true }).click();
const button = (page, name) => form(page).getByRole("button", { name });

async function openTeach(page, t_s = 60) {
  await setState(page, "time_s", t_s);
  await tab(page, "Teach");
}

/** Values of the axes as they are shown, by letter. */
const values = (page) =>
  page.evaluate(() => {
    const { axes } = window.studio.store.get("run").robots[0].scene;
    const jog = window.studio.store.get("jog");
    return Object.fromEntries(axes.map(({ letter, rotary, zero }, i) => [letter, zero + (rotary ? (jog[i] * 180) / Math.PI : jog[i])]));
  });

/** Returns TCP and tool axis as displayed. */
async function tip(page) {
  const cells = await form(page).locator(".tip-pad output").allTextContents();
  const numbers = cells.map(parseFloat);
  return { tip_mm: [numbers[0], numbers[2], numbers[4]], axis: [numbers[1], numbers[3], numbers[5]] };
}

const near = (a, b, most = 1e-6) => assert.ok(Math.abs(a - b) <= most, `${a}, not ${b}`);
const nearAll = (a, b, most) => a.forEach((value, i) => near(value, b[i], most));

/** Waits until the joints are others, as `act` brings it about. */
async function moves(page, act) {
  await page.evaluate(() => (window.jogBefore = window.studio.store.get("jog")));
  await act();
  await page.waitForFunction(() => window.studio.store.get("jog") !== window.jogBefore, null, { timeout: 20_000 });
}

export default {
  "joints are moved by slider, number and button, the drawn machine follows, and an end stops them": (places) =>
    withPage(places.studio, async (page) => {
      await openTeach(page);
      const begun = await pictureOfView(page);
      const { X, Y, B } = await values(page);
      await button(page, /^X \+/).click();
      near((await values(page)).X, X + 10);
      const moved = await pictureOfView(page);
      assert.ok((await difference(page, begun, moved)) > 0.005, "the machine is drawn elsewhere");

      await form(page).getByLabel("Axis Y, mm").fill("800.5");
      await form(page).getByLabel("Axis Y, mm").press("Enter");
      near((await values(page)).Y, 800.5);
      await form(page).getByLabel("Axis B, between its limits").focus();
      await page.keyboard.press("ArrowLeft");
      assert.ok((await values(page)).B < B);

      // While held, it continues; at the end it stops.
      await form(page).getByLabel("Linear step").selectOption("100 mm");
      const { x, y } = await button(page, /^Y −/).boundingBox();
      await page.mouse.move(x + 5, y + 5);
      await page.mouse.down();
      await page.waitForFunction(() => /limit of Y is 0/.test(document.querySelector("#side .teach .said").textContent), null, { timeout: 20_000 });
      await page.mouse.up();
      near((await values(page)).Y, 0);
      assert.match(await form(page).locator(".joint").nth(1).innerText(), /at its limit/);
      await form(page).getByLabel("Axis C, °").fill("85");
      await form(page).getByLabel("Axis C, °").press("Enter");
      assert.match(await form(page).locator(".joint").nth(4).innerText(), /5\.00° to its limit/);
      await form(page).getByLabel("Axis C, °").fill("95");
      await form(page).getByLabel("Axis C, °").press("Enter");
      near((await values(page)).C, 90);
      assert.match(await form(page).locator(".said").textContent(), /limit of C is 90/);

      // Another form shows the run; afterwards the joints are as before, until they are reset.
      const at = await values(page);
      await tab(page, "Run");
      assert.equal(await state(page, "jog"), null);
      await tab(page, "Teach");
      assert.deepEqual(await values(page), at);
      await button(page, "From the run").click();
      near((await values(page)).X, X);
      near((await values(page)).Y, Y);
      assert.ok((await difference(page, begun, await pictureOfView(page))) < 0.001);
    }),

  "the tip goes along the axes of the work and keeps the tool's axis, and turns on the spot": (places) =>
    withPage(places.studio, async (page) => {
      await openTeach(page);
      const before = await tip(page);
      await moves(page, () => button(page, "TCP along Z of the work +").click());
      await moves(page, () => button(page, "TCP along X of the work −").click());
      const after = await tip(page);
      nearAll(after.tip_mm, [before.tip_mm[0] - 10, before.tip_mm[1], before.tip_mm[2] + 10], 0.001);
      nearAll(after.axis, before.axis, 1e-4);
      await moves(page, () => button(page, "Turn the tool about X of the work +").click());
      const turned = await tip(page);
      nearAll(turned.tip_mm, after.tip_mm, 0.001);
      const angle = Math.acos(turned.axis.reduce((sum, value, i) => sum + value * after.axis[i], 0));
      assert.ok(angle > 0.05 && angle < 0.18, `${angle} rad`);

      // Beyond the range it does not go, and says so.
      await form(page).getByLabel("Linear step").selectOption("100 mm");
      const at = await values(page);
      await button(page, "TCP along Z of the work −").click();
      await form(page).locator(".said.fault").filter({ hasText: "The TCP cannot reach this position: Z would leave its range." }).waitFor();
      assert.deepEqual(await values(page), at);
    }),

  "three points are recorded, written and run: the tip goes through them, and the machine to each": (places) =>
    withPage(
      places.studio,
      async (page) => {
        await openTeach(page);
        await form(page).getByLabel("Axis C, °").fill("20");
        await form(page).getByLabel("Axis C, °").press("Enter");
        const points = [];
        for (const act of [/^Y \+/, /^X \+/, /^Z \+/]) {
          for (let i = 0; i < 3; ++i) await button(page, act).click();
          await button(page, "Record point").click();
          points.push((await page.evaluate(() => window.studio.store.get("path").file.paths[0].targets)).at(-1));
        }
        await untilSettled(page);
        if (process.env.GSIM_RENEW_PICTURES) await page.screenshot({ path: join(docs(places), "studio-teach.png") });
        assert.deepEqual(points.map(({ feed_mm_min }) => feed_mm_min), [1000, undefined, undefined]);
        assert.equal(await page.evaluate(() => window.studio.session.history.undoLabel), "recording a point");
        for (const { tool_axis } of points) near(Math.hypot(...tool_axis), 1, 1e-5);

        await tab(page, "Paths");
        assert.equal(await page.locator("#side .tree [role=treeitem]").count(), 4);
        await page.locator("#side .write .primary").click();
        await page.waitForFunction(() => window.studio.store.get("run")?.report?.program === "part.nc" && !window.studio.store.get("running"), null, { timeout: 60_000 });
        assert.equal(await page.evaluate(() => window.studio.store.get("run").report.status), "completed");
        const deviation_mm = await page.evaluate((expectedValue) => {
          const { sections } = window.studio.store.get("run").robots[0].segments;
          const away = ([x, y, z]) =>
            Math.min(
              ...sections.flatMap(({ vertex_mm }) =>
                Array.from({ length: vertex_mm.length / 3 }, (_, i) => Math.hypot(vertex_mm[3 * i] - x, vertex_mm[3 * i + 1] - y, vertex_mm[3 * i + 2] - z)),
              ),
            );
          return expectedValue.map(({ position_mm }) => away(position_mm));
        }, points);
        assert.ok(Math.max(...deviation_mm) < 0.01, `${deviation_mm}`);

        // To the first of them, and on from there.
        await page.evaluate(() => window.studio.store.set("pathPoint", { path: 0, target: 0 }));
        await tab(page, "Teach");
        await moves(page, () => button(page, "Go to the point").click());
        for (const { position_mm, tool_axis } of points) {
          const there = await tip(page);
          nearAll(there.tip_mm, position_mm, 0.001);
          nearAll(there.axis, tool_axis, 1e-4);
          const next = button(page, "Next");
          if (await next.isEnabled()) await moves(page, () => next.click());
        }
      },
      { width: 1280, height: 800 },
    ),

  "what touches is said": (places) =>
    withPage(places.studio, async (page) => {
      await run(page, { program: "samples/cell/clamp.nc", cell: "samples/cell/table.toml" });
      const [{ t_s }] = await page.evaluate(() => window.studio.store.get("run").report.collisions);
      await openTeach(page, t_s + 0.05);
      await form(page).locator(".said.fault").filter({ hasText: /Contact: .*(nozzle( end)? – left clamp|left clamp – nozzle)/ }).waitFor();
      await form(page).getByLabel("Axis Z, mm").fill("500");
      await form(page).getByLabel("Axis Z, mm").press("Enter");
      await page.waitForFunction(() => document.querySelector("#side .teach .said").textContent === "", null, { timeout: 20_000 });
    }),
};

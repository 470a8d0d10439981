// Contents that the page shows.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { join } from "node:path";
import { comparePicture, countPixels, difference, pictureOfView, run, setState, untilSettled, state, withPage } from "../steps.mjs";

const RED = [0, 150, 90];
const CELL = { program: "samples/cell/clamp.nc", cell: "samples/cell/table.toml" };

async function at(page, time_s) {
  await setState(page, "time_s", time_s);
}

export default {
  "the page opens from a disk and runs the wheel": (places) =>
    withPage(places.studio, async (page) => {
      assert.match(await page.locator("#side").innerText(), /The program reached its end\. No contact, for \d+ pairs of bodies that were checked\./);
      const report = await page.evaluate(() => window.studio.store.get("run").report);
      assert.equal(report.cycle_time_s, 129.989152064);
    }),

  "the wheel looks as it did": (places) =>
    withPage(places.studio, async (page) => {
      await at(page, 60);
      await comparePicture(page, places, "wheel-light");
      await setState(page, "theme", "dark");
      await comparePicture(page, places, "wheel-dark");
    }),

  "machines with arms and mills look as they did": (places) =>
    withPage(places.studio, async (page) => {
      const mills = { program: "samples/mill/dome.nc", machine: "samples/machines/mill-head-table.toml" };
      const arms = { program: "folds.nc", machine: "samples/machines/arm6.toml" };
      const routers = { program: "samples/rosette.ngc", machine: "samples/machines/linuxcnc-router.toml", dialect: "rs274ngc" };
      for (const [machine, setup] of Object.entries({ mills, arms, routers })) {
        const { status } = await run(page, setup, { "folds.nc": "G0 A40 B20 C-70 U10 V50\nG0 A-30 B60 C-90 W90\nM2\n" });
        assert.equal(status, "completed");
        await at(page, machine === "mills" ? 20 : 1);
        await comparePicture(page, places, machine);
      }
    }),

  "at 60 s the axes are those of gsim-run --trajectory": (places) =>
    withPage(places.studio, async (page) => {
      const csv = execFileSync(
        places.gsimRun,
        ["--quiet", "--machine", "machines/af5-measured.toml", "--trajectory", "-", "--step", "60", "wheel.nc"],
        { cwd: places.samples, encoding: "utf8" },
      );
      const values = csv.split("\n").find((line) => line.startsWith("60,")).split(",").map(Number);
      const axes = await page.evaluate(() => window.studio.store.get("run").robots[0].axes_at(60));
      axes.forEach((value, i) => assert.ok(Math.abs(value - values[i + 2]) < 1e-6, `axis ${i}: ${value}, ${values[i + 2]}`));
    }),

  "scrubbing moves the machine and no other pixel of the way's end": (places) =>
    withPage(places.studio, async (page) => {
      await at(page, 30);
      const before = await pictureOfView(page);
      await at(page, 90);
      const after = await pictureOfView(page);
      assert.ok((await difference(page, before, after)) > 0.005);
      await at(page, 30);
      assert.ok((await difference(page, before, await pictureOfView(page))) < 0.002);
    }),

  "a collision is lit from its instant on": (places) =>
    withPage(places.studio, async (page) => {
      const { status } = await run(page, CELL);
      assert.equal(status, "completed");
      const [collision] = await page.evaluate(() => window.studio.store.get("run").report.collisions);
      assert.deepEqual(collision.pair, ["nozzle end", "left clamp"]);
      await at(page, collision.t_s - 0.05);
      const before = await countPixels(page, await pictureOfView(page), RED);
      await at(page, collision.t_s + 0.001);
      const lit = await countPixels(page, await pictureOfView(page), RED);
      assert.ok(lit > before + 50, `${before} red pixels before, ${lit} behind`);
    }),

  "the machine and its cell are hidden each by itself, and what is hidden is not clicked": (places) =>
    withPage(places.studio, async (page) => {
      await run(page, CELL);
      await at(page, 20);
      await page.evaluate(() => window.studio.view.setStandardView("top"));
      // Next to the path, at the head above the workpiece.
      const clicked = async () => {
        await untilSettled(page);
        const [x, y] = await page.evaluate(() => {
          const { store, view } = window.studio;
          const [x_mm, y_mm] = store.get("run").robots[0].axes_at(store.get("time_s"));
          return view.screenPosition([x_mm + 70, y_mm, 0]);
        });
        await page.mouse.click(x, y);
        return state(page, "body");
      };
      const show = async (layer) => {
        await page.locator("#view .layers summary").click();
        await page.locator("#view .layers").getByLabel(layer, { exact: true }).click();
        await page.keyboard.press("Escape");
      };
      assert.equal(await clicked(), "turntable");
      await show("Machine");
      assert.equal(await clicked(), "sheet");
      await show("Cell");
      assert.equal(await clicked(), null);
      await show("Machine");
      assert.equal(await clicked(), "turntable");
    }),

  "Escape ends measuring from the button on": (places) =>
    withPage(places.studio, async (page) => {
      await run(page, { program: "samples/wheel.nc" });
      await page.getByRole("button", { name: "Measure between two points" }).click();
      assert.equal(await state(page, "measuring"), true);
      await page.keyboard.press("Escape");
      assert.equal(await state(page, "measuring"), false);
    }),

  "several robots are in one picture, and each has its charts": (places) =>
    withPage(places.studio, async (page) => {
      await run(page, { program: "samples/cell/cell.lua", robots: "samples/cell/robots.toml" });
      const names = await page.evaluate(() => window.studio.store.get("run").robots.map((robot) => robot.name));
      assert.equal(names.length, 2);
      await at(page, 5);
      await comparePicture(page, places, "robots");
    }),

  "inches are shown everywhere at once": (places) =>
    withPage(places.studio, async (page) => {
      await page.locator("#bar .preferences button").first().click();
      assert.equal(await state(page, "units"), "inch");
      const side = await page.locator("#side").innerText();
      assert.match(side, /\d in\b/);
      assert.doesNotMatch(side, /\d mm\b/);
    }),

  "nothing sticks out of the page of a tablet": (places) =>
    withPage(
      places.studio,
      async (page) => {
        const [width, height] = await page.evaluate(() => [document.documentElement.scrollWidth, document.documentElement.scrollHeight]);
        assert.ok(width <= 1024 && height <= 768, `${width} x ${height}`);
      },
      { width: 1024, height: 768 },
    ),

  "a page of gsim-run --view has the run, and no engine": async (places) => {
    const file = join(places.build, "view-of-test.html");
    execFileSync(places.gsimRun, ["--quiet", "--view", file, "wheel.nc"], { cwd: places.samples });
    await withPage(file, async (page) => {
      assert.equal(await page.evaluate(() => window.studio.session.canRun), false);
      assert.equal(await page.locator("#run-button").count(), 0);
      assert.match(await page.locator("#code").innerText(), /WHEEL/);
      await at(page, 100);
      const axes = await page.evaluate(() => window.studio.store.get("run").robots[0].axes_at(100));
      assert.equal(axes.length, 5);
      await pictureOfView(page);
    });
  },
};

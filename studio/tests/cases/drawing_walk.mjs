// Second walk of docs/studio.md: a newcomer has a drawing, flat material on a table and a gantry, and leaves
// with a program that was checked there. With GSIM_RENEW_PICTURES=1 its pictures are written into
// docs/images.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { copyFileSync, mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { dropFiles, untilSettled, withPage } from "../steps.mjs";

const CELL = "samples/cell/table.toml";
/**
 * Time budget of the walk, s: in the page alone, for a user that reads its texts. The machine's time is a
 * small part of it.
 */
const BUDGET_S = 300;

const side = (page) => page.locator("#side");
const tab = (page, name) => side(page).getByRole("tab", { name, exact: true }).click();

/** Fills in the position of the drawing's zero, makes the path, and waits for it. */
async function makePath(page, dialog, origin_mm) {
  for (const [letter, value] of Object.entries(origin_mm)) await dialog.getByLabel(`Origin at ${letter}`).fill(String(value));
  await dialog.getByRole("button", { name: "Make path" }).click();
  await dialog.waitFor({ state: "detached" });
  await side(page).getByText(/7 contours, 7 pierces/).waitFor();
}

/** Writes the program, and waits until it has run. */
async function writeAndRun(page, program) {
  await side(page).locator(".write .primary").click();
  await page.waitForFunction((name) => window.studio.store.get("run")?.report?.program === name && !window.studio.store.get("running"), program, { timeout: 60_000 });
  return page.evaluate(() => window.studio.store.get("run").report);
}

/** The report of the native program on the saved file. */
function checkedElsewhere(places, file) {
  const folder = mkdtempSync(join(tmpdir(), "gsim-walk-"));
  try {
    copyFileSync(file, join(folder, "plate.nc"));
    const words = ["--machine", join(places.samples, "machines/af5-measured.toml"), "--cell", join(places.samples, "cell/table.toml")];
    return JSON.parse(execFileSync(places.gsimRun, [...words, "--dialect", "ab9", "--json", join(folder, "plate.nc")], { encoding: "utf8" }));
  } finally {
    rmSync(folder, { recursive: true });
  }
}

export default {
  "somebody new goes from a drawing to a checked program": (places) =>
    withPage(
      places.studio,
      async (page) => {
        let pictures_s = 0;
        const began = performance.now();
        const picture = async (name) => {
          const from = performance.now();
          await untilSettled(page);
          if (process.env.GSIM_RENEW_PICTURES) await page.screenshot({ path: join(places.samples, `../docs/images/studio-drawing-${name}.png`) });
          pictures_s += (performance.now() - from) / 1000;
        };

        // 1: the surroundings of the machine, and the drawing.
        await page.locator("#bar").getByLabel("Cell", { exact: true }).selectOption(CELL);
        await page.waitForFunction(() => window.studio.store.get("run")?.robots[0]?.scene.bodies.some(({ name }) => name === "sheet"));
        await dropFiles(page, join(places.samples, "plate.svg"));
        const dialog = page.getByRole("dialog", { name: "Path from drawing" });
        await dialog.getByLabel("Material").selectOption("aluminum");
        await dialog.getByLabel("Thickness").fill("10");
        for (const [letter, value] of Object.entries({ X: 110, Y: 350, Z: 0 })) await dialog.getByLabel(`Origin at ${letter}`).fill(String(value));
        await picture("asked");

        // 2: the path.
        await makePath(page, dialog, { X: 110 });
        await page.evaluate(() => window.studio.view.setStandardView("top"));
        await picture("path");

        // 3: the program, and that it does what the path says.
        const first = await writeAndRun(page, "plate.nc");
        assert.equal(first.status, "completed");
        const said = side(page).locator(".round-trip");
        await said.filter({ hasText: /plate\.nc is at most [\d.]+ mm off the path/ }).waitFor();
        const [, path_off_mm, path_mm] = (await said.textContent()).match(/is at most ([\d.]+) mm off .* path file at most ([\d.]+) mm off/).map(Number);
        assert.ok(path_off_mm < 0.02 && path_mm < 0.02, `${path_off_mm}, ${path_mm} mm`);
        await said.scrollIntoViewIfNeeded();
        await picture("written");

        // 4: the error: a clamp holds the material there.
        assert.ok(first.collisions.some(({ pair }) => pair.includes("nozzle") && pair.includes("left clamp")));
        await tab(page, "Run");
        await tab(page, "Summary");
        await side(page).getByText(/nozzle.*left clamp|left clamp.*nozzle/).first().click();
        await page.evaluate(() => window.studio.view.setStandardView("iso"));
        await picture("collision");

        // 5: elsewhere on the material, as a second path and program, and without error.
        await tab(page, "Paths");
        await side(page).getByRole("button", { name: "From drawing…" }).click();
        const again = page.getByRole("dialog", { name: "Path from drawing" });
        await again.getByLabel("linking moves avoid machine and cell").check();
        await again.getByRole("button", { name: "Make path" }).click();
        await again.getByRole("alert").filter({ hasText: "touches 'left clamp'" }).waitFor();
        await makePath(page, again, { X: 160 });
        const second = await writeAndRun(page, "plate 2.nc");
        assert.deepEqual([second.status, second.collisions ?? []], ["completed", []]);
        await tab(page, "Run");
        await tab(page, "Summary");
        await picture("checked");
        const download = page.waitForEvent("download");
        await page.getByRole("button", { name: "Save", exact: true }).first().click();
        const saved = await download;
        assert.equal(saved.suggestedFilename(), "plate 2.nc");

        const took_s = (performance.now() - began) / 1000 - pictures_s;
        console.log(`  the walk took the machine ${took_s.toFixed(1)} s of a person's ${BUDGET_S}`);

        const elsewhere = checkedElsewhere(places, await saved.path());
        assert.deepEqual([elsewhere.status, elsewhere.collisions ?? []], ["completed", []]);
        assert.ok(Math.abs(elsewhere.cycle_time_s - second.cycle_time_s) < 1e-6);
      },
      { width: 1280, height: 800 },
    ),
};

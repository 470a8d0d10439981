// Walk of docs/studio.md: a newcomer to the page finds the slowest block of a program, sees why, changes the
// feed there and compares. With GSIM_RENEW_PICTURES=1 its pictures are written into docs/images.

import assert from "node:assert/strict";
import { join } from "node:path";
import { setState, untilSettled, state, withPage } from "../steps.mjs";

const docs = (places) => join(places.samples, "../docs/images");

export default {
  "somebody new finds the slowest block, changes its feed and compares": (places) =>
    withPage(
      places.studio,
      async (page) => {
        const picture = async (name) => {
          await untilSettled(page);
          if (process.env.GSIM_RENEW_PICTURES) await page.screenshot({ path: join(docs(places), `studio-${name}.png`) });
        };
        await setState(page, "time_s", 60);
        await picture("wheel");

        await page.locator("#gallery-button").click();
        await picture("samples");
        await page.getByRole("button", { name: /A clamp in the tool path/ }).click();
        await page.waitForFunction(() => window.studio.store.get("run")?.report?.program === "samples/cell/clamp.nc");
        await picture("opened");

        await page.getByRole("tab", { name: "Blocks" }).click();
        const slowest = page.locator("#results-panel-blocks tbody tr").first();
        assert.match(await slowest.innerText(), /20\.031/);
        await slowest.click();
        await page.waitForFunction(() => window.studio.store.get("selection")?.line === 6);
        assert.match(await page.locator("#side").innerText(), /feed/i);
        await picture("slowest");

        await page.locator("#code .cm-line").filter({ hasText: "Y500 F900" }).dblclick({ position: { x: 4, y: 8 } });
        await page.keyboard.press("End");
        await page.keyboard.press("Backspace");
        await page.keyboard.press("Backspace");
        await page.keyboard.press("Backspace");
        await page.keyboard.type("1800");
        await page.keyboard.press("Control+Enter");
        await page.waitForFunction(() => window.studio.store.get("run")?.report?.cycle_time_s < 40);

        await page.getByRole("tab", { name: "Compare" }).click();
        const compared = await page.locator("#side").innerText();
        assert.match(compared, /26\.161 s faster/);
        assert.match(compared, /changed\s+20\.031 s\s+10\.061 s/);
        await picture("compared");

        await page.getByRole("tab", { name: "Summary" }).click();
        await page.locator("#side").getByText(/nozzle.*left clamp|left clamp.*nozzle/).first().click();
        await page.waitForFunction(() => window.studio.store.get("selection")?.line === 13);
        const [collision] = await page.evaluate(() => window.studio.store.get("run").report.collisions);
        assert.ok(Math.abs((await state(page, "time_s")) - collision.t_s) < 1e-6);
        await picture("collision");
      },
      { width: 1280, height: 800 },
    ),
};

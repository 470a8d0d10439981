// Variants: set-ups run and compared, two machines on one clock, what-if from a block on, kept in a file.

import assert from "node:assert/strict";
import { readFileSync, mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { withServed } from "../served.mjs";
import { difference, run, setState, untilSettled, state, withPage } from "../steps.mjs";

const WHEEL = "samples/wheel.nc";
const MEASURED = "samples/machines/af5-measured.toml";
const LARGE = "samples/machines/af5.toml";
const ENDLESS = "local _ENV = require 'gsim'\nprogram(1, function()\n  F(6000) while true do G1{x=100} G1{x=0} end\nend)\n";
/** A subprogram of two lines, run three times. */
const LOOP = "%\nO0001\nG21 G90 G94\nG0 X0 Y0\nM98 P2 L3\nG1 X50 F2000\nM30\nO0002\nG91\nG1 X10 F1500\nG1 Y10 F600\nG90\nM99\n%\n";

const docs = (places) => join(places.samples, "../docs/images");
const form = (page) => page.locator("#side .variants");
const button = (page, name) => form(page).getByRole("button", { name, exact: true });
const field = (page, label) => form(page).getByLabel(label, { exact: true });
const tab = (page, name) => page.locator("#side").getByRole("tab", { name, exact: true }).click();

/** The rows of the table, cell by cell. */
const rows = (page) =>
  form(page).locator(".variant-list tbody tr").evaluateAll((all) => all.map((row) => [...row.cells].map((cell) => cell.innerText.replace(/\s+/g, " ").trim())));
const names = async (page) => (await rows(page)).map(([name]) => name);
const row = (page, i) => form(page).locator(".variant-list tbody tr").nth(i);
const saidOf = (page) => form(page).locator(".said").innerText();
const listFile = (page) => page.evaluate(() => JSON.parse(window.studio.documents.text(window.studio.store.get("variantsFile"))));

/** "2:09.989" and "39.125 s" in seconds. */
const secondsOf = (text) => text.replace(/ s.*/, "").split(":").reduce((sum, part) => 60 * sum + Number(part), 0);
const near = (a, b, most) => assert.ok(Math.abs(a - b) <= most, `${a}, not ${b}`);

/** Waits until no variant runs any more, and each row shows a result. */
const allRan = (page) =>
  page.waitForFunction(
    () => {
      const found = [...document.querySelectorAll("#side .variant-list .standing")];
      const isRunning = !document.querySelector("#side .variants .running").hidden;
      return !isRunning && found.length > 0 && found.every((cell) => !/not run yet|run it again/.test(cell.textContent));
    },
    null,
    { timeout: 60_000 },
  );

async function change(page, label, value) {
  await field(page, label).fill(value);
  await field(page, label).press("Enter");
}

/** As the wheel runs, on the large machine, and there at half the feed. */
async function threeVariants(page) {
  await tab(page, "Variants");
  await button(page, "Store the current setup").click();
  await button(page, "Add variant").click();
  await field(page, "Machine").selectOption(LARGE);
  await change(page, "Name", "large");
  await button(page, "Copy").click();
  await change(page, "Feed override, %", "50");
  await change(page, "Name", "slow");
  await button(page, "Run all").click();
  await allRan(page);
}

const compared = async (page, first, second) => {
  await field(page, "First").selectOption(first);
  await field(page, "Second").selectOption(second);
};

const canvases = async (page) => {
  await untilSettled(page);
  const all = page.locator("#view canvas");
  assert.equal(await all.count(), 2);
  return [await all.nth(0).screenshot(), await all.nth(1).screenshot()];
};

export default {
  "variants take the times of runs that the bar is set to, and say what they differ by": (places) =>
    withPage(places.studio, async (page) => {
      await threeVariants(page);
      const table = await rows(page);
      assert.deepEqual(table.map(([name]) => name), [
        "current setup wheel.nc, af5-measured.toml",
        "large af5.toml",
        "slow af5.toml, feed 50 %",
      ]);
      assert.deepEqual(table.map(([, , , standing]) => standing), ["no errors", "no errors", "no errors"]);
      const times = table.map(([, time]) => secondsOf(time));
      const setups = [{ machine: MEASURED }, { machine: LARGE }, { machine: LARGE, feed_override_percent: 50 }];
      for (const [i, setup] of setups.entries()) {
        const { cycle_time_s } = await run(page, { program: WHEEL, feed_override_percent: 100, ...setup });
        near(times[i], cycle_time_s, 0.0006);
      }
      near(secondsOf(table[2][2].slice(1)), times[2] - times[0], 0.0011);
      assert.ok(times[2] > times[1] + 10, `half the feed takes longer: ${times}`);
    }),

  "which of two is faster, and where: totals, blocks, filter, and the way to each": (places) =>
    withPage(places.studio, async (page) => {
      await threeVariants(page);
      await compared(page, "large", "slow");
      const said = await saidOf(page);
      assert.match(said, /^“large” is \S+( s)? \(\S+ %\) faster: \S+( s)? against \S+( s)? of “slow”\./);
      assert.match(said, /The largest part is at line \d+ \+\S+ s \(programmed feed\)/);
      // The differences of all blocks, and those between them, add up to the total.
      const sums = await page.evaluate(() => {
        const all = [...document.querySelectorAll("#side .variant-compare .differences tbody tr")];
        return all.map((each) => [...each.cells].map((cell) => cell.textContent));
      });
      const number = (text) => secondsOf(text.replace(/[a-z ]*$/i, (end) => (/^ s/.test(end) ? " s" : ""))) || 0;
      const differences = sums.map((cells) => number(cells[3].slice(1)) * (cells[3].startsWith("−") ? -1 : 1));
      assert.deepEqual([...differences].sort((a, b) => Math.abs(b) - Math.abs(a)), differences, "the greatest difference first");
      const total = (await rows(page)).slice(1).map(([, time]) => secondsOf(time));
      const displayed = await form(page).locator(".variant-compare p.note[role=status]").innerText();
      const [, few, many] = /^(\d+) of (\d+) blocks/.exec(displayed);
      if (few === many) near(differences.reduce((sum, each) => sum + each, 0), total[1] - total[0], 0.0006 * differences.length);
      assert.ok(differences[0] > 0.1, "the first one is slower at half the feed");
      assert.match(sums[0][2], /feed/, "and it says what limits it");

      const line = /^\d+/.exec(sums[1][0])[0];
      await form(page).getByRole("searchbox", { name: "Filter: line or text" }).fill(line);
      await page.waitForFunction((expectedValue) => {
        const all = [...document.querySelectorAll("#side .variant-compare .differences tbody tr")];
        return all.length > 0 && all.every((each) => each.cells[0].textContent.startsWith(`${expectedValue} `));
      }, line);
      await form(page).locator(".variant-compare .differences tbody tr").first().click();
      const at = await page.evaluate(() => {
        const { store, session } = window.studio;
        const [robot] = store.get("run").robots;
        const { line, block } = store.get("selection");
        return { line, start_s: robot.blocks.start_s(block), t_s: store.get("time_s"), machine: session.setup.machine, percent: session.setup.feed_override_percent };
      });
      assert.equal(String(at.line), line);
      assert.equal(at.t_s, at.start_s);
      assert.deepEqual([at.machine, at.percent], [LARGE, 100], "the page has the first one's set-up with its run");
      assert.equal(await page.locator("#code .cm-lineNumbers .cm-activeLineGutter").first().innerText(), line);
    }),

  "two machines stand beside each other on one clock, and the faster one waits at its end": (places) =>
    withPage(
      places.studio,
      async (page) => {
        await threeVariants(page);
        await compared(page, "current setup", "slow");
        await form(page).getByLabel("Show both machines on one clock").check();
        const [end_s, other_s] = await page.evaluate(() => {
          const { store } = window.studio;
          return [store.get("run").end_s, store.get("comparisonRun").run.end_s];
        });
        assert.ok(other_s > end_s + 1, `${end_s} ${other_s}`);
        await setState(page, "time_s", 20);
        const begun = await canvases(page);
        assert.ok((await difference(page, ...begun)) > 0.001, "they are not at the same place");
        await setState(page, "time_s", 70);
        const later = await canvases(page);
        for (const i of [0, 1]) assert.ok((await difference(page, begun[i], later[i])) > 0.001, `canvas ${i} follows the clock`);
        if (process.env.GSIM_RENEW_PICTURES) {
          await form(page).locator(".variant-compare").evaluate((part) => part.scrollIntoView({ block: "start" }));
          await page.locator("#side").evaluate((side) => side.scrollBy(0, -160));
          await page.screenshot({ path: join(docs(places), "studio-variants.png") });
        }

        // After the end of one run the other continues.
        await setState(page, "time_s", end_s + 1);
        const ended = await canvases(page);
        await setState(page, "time_s", other_s);
        const atEnd = await canvases(page);
        assert.ok((await difference(page, ended[0], atEnd[0])) < 0.0005, "the first one stands at its end");
        assert.ok((await difference(page, ended[1], atEnd[1])) > 0.001, "the second one goes on");
        assert.match(await page.locator("#time .whole-time").innerText(), new RegExp(`${Math.floor(other_s / 60)}:`));

        // Played from near the end it stops at the longer one's.
        await setState(page, "time_s", other_s - 0.3);
        await setState(page, "playing", true);
        await page.waitForFunction(() => !window.studio.store.get("playing"), null, { timeout: 20_000 });
        assert.equal(await state(page, "time_s"), other_s);

        // Turned in one, turned in both.
        await setState(page, "time_s", 20);
        const before = await canvases(page);
        await page.evaluate(() => window.studio.view.orbit(120, 40));
        const turned = await canvases(page);
        for (const i of [0, 1]) assert.ok((await difference(page, before[i], turned[i])) > 0.005, `canvas ${i} turns`);
        await page.locator("#view .beside .surface").focus();
        await page.keyboard.press("1");
        const above = await canvases(page);
        for (const i of [0, 1]) assert.ok((await difference(page, turned[i], above[i])) > 0.005, `canvas ${i} turns with the second`);

        // A run of the page's own ends it.
        await page.locator("#run-button").click();
        await page.waitForFunction(() => window.studio.store.get("comparisonRun") === null, null, { timeout: 20_000 });
        assert.equal(await page.locator("#view .beside").isVisible(), false);
      },
      { width: 1440, height: 900 },
    ),

  "a changed program makes figures those of an earlier text, until it is what it was or is run again": (places) =>
    withPage(places.studio, async (page) => {
      await threeVariants(page);
      await page.evaluate((name) => {
        const { documents, session } = window.studio;
        session.history.edit("a feed", { documents: { [name]: documents.text(name).replace("F6350", "F3000") } });
      }, WHEEL);
      await page.waitForFunction(() => /of an earlier wheel.nc: run it again/.test(document.querySelector("#side .variant-list").innerText));
      const table = await rows(page);
      assert.deepEqual(table.slice(1).map(([, time, against, standing]) => [time, against, standing]), Array(2).fill(["–", "", "of an earlier wheel.nc: run it again"]));
      assert.match(await saidOf(page), /“large”: of an earlier wheel.nc: run it again\./);
      await page.keyboard.press("Escape");
      await page.evaluate(() => window.studio.session.history.undo());
      await page.waitForFunction(() => !/earlier/.test(document.querySelector("#side .variant-list").innerText), null, { timeout: 20_000 });
      const fresh = (await rows(page)).map(([, time]) => time);
      assert.ok(fresh.every((time) => time !== "–"), `${fresh}`);
    }),

  "a variant that fails says why, and one that is run ends those under way": (places) =>
    withPage(places.studio, async (page) => {
      await page.evaluate((endless) => {
        const { documents } = window.studio;
        documents.put("broken.nc", "G21\nG1 X10 F100\nG1 X1O\nM2\n");
        documents.put("endless.lua", endless);
      }, ENDLESS);
      await tab(page, "Variants");
      await button(page, "Store the current setup").click();
      await button(page, "Add variant").click();
      await field(page, "Program").selectOption("broken.nc");
      await button(page, "Run").click();
      await allRan(page);
      const [, , , standing] = (await rows(page))[1];
      assert.match(standing, /^failed: \S+/);
      await button(page, "Add variant").click();
      await field(page, "Program").selectOption("endless.lua");
      await button(page, "Run").click();
      await form(page).locator(".running").filter({ hasText: "Running “variant 2”" }).waitFor();
      await page.locator("#run-button").click();
      await page.waitForFunction(() => document.querySelector("#side .variants .running").hidden && !window.studio.store.get("running"), null, { timeout: 20_000 });
      assert.equal((await rows(page))[2][3], "not run yet");
      assert.equal(await page.evaluate(() => window.studio.store.get("run").report.status), "completed");
      await button(page, "Run").click();
      await button(page, "Cancel").click();
      await form(page).locator(".running").waitFor({ state: "hidden" });
      assert.equal((await rows(page))[2][3], "not run yet");
    }),

  "another control runs in place of the machine's own": (places) =>
    withPage(places.studio, async (page) => {
      await tab(page, "Variants");
      await button(page, "Store the current setup").click();
      await button(page, "Copy").click();
      await field(page, "Controller").selectOption("exact-stop");
      await button(page, "Run").click();
      await allRan(page);
      const times = (await rows(page)).map(([, time]) => secondsOf(time));
      assert.ok(times[1] > times[0] + 1, `stopping at each end takes longer: ${times}`);
      await button(page, "Apply to the bar").click();
      const displayed = await page.evaluate(() => [window.studio.store.get("run").report.controller, window.studio.session.setup.controller]);
      assert.deepEqual(displayed, ["exact-stop", "exact-stop"]);
      await run(page, { program: WHEEL, machine: MEASURED, controller: "exact-stop" });
      near(await page.evaluate(() => window.studio.store.get("run").report.cycle_time_s), times[1], 0.0006);
    }),

  "adding, changing and removing is taken back and done again, with the figures": (places) =>
    withPage(places.studio, async (page) => {
      await threeVariants(page);
      const all = await rows(page);
      const undo = () => page.locator("#undo-button").click();
      const redo = () => page.locator("#redo-button").click();
      const shows = (count) => page.waitForFunction((expectedValue) => document.querySelectorAll("#side .variant-list tbody tr").length === expectedValue, count);
      await row(page, 1).click();
      await page.keyboard.press("Delete");
      await shows(2);
      assert.equal(await page.locator("#undo-button").getAttribute("title"), "Undo: removing variant large (Ctrl+Z)");
      await undo();
      await shows(3);
      assert.deepEqual(await rows(page), all);
      await undo(); // the name
      await undo(); // the override
      await page.waitForFunction(() => {
        const text = document.querySelector("#side .variant-list").innerText;
        return /large, copy/.test(text) && !/feed 50/.test(text);
      });
      assert.match((await names(page))[2], /^large, copy af5\.toml$/);
      assert.equal((await rows(page))[2][1], all[1][1], "of the same set-up the run is the same");
      await undo();
      await shows(2);
      for (let i = 0; i < 3; ++i) await redo();
      await row(page, 2).filter({ hasText: /^slow/ }).waitFor();
      assert.deepEqual(await rows(page), all);
    }),

  "variants are saved as a file, and opened again": (places) => {
    const folder = mkdtempSync(join(tmpdir(), "gsim-variants-"));
    const file = join(folder, "wheel.variants.json");
    return withPage(places.studio, async (page) => {
      await threeVariants(page);
      const downloading = page.waitForEvent("download");
      await button(page, "Save").click();
      const download = await downloading;
      assert.equal(download.suggestedFilename(), "wheel.variants.json");
      await download.saveAs(file);
      const [one, , slow] = JSON.parse(readFileSync(file, "utf8")).variants;
      assert.deepEqual(one, { name: "current setup", program: WHEEL, machine: MEASURED });
      assert.deepEqual(slow, { name: "slow", program: WHEEL, machine: LARGE, feed_override_percent: 50 });
      assert.equal(await page.evaluate(() => window.studio.documents.unsaved), false);
    })
      .then(() =>
        withPage(places.studio, async (page) => {
          const chooser = page.waitForEvent("filechooser");
          await page.locator("#open-button").click();
          await (await chooser).setFiles([file]);
          await form(page).locator(".variant-list").waitFor();
          assert.equal((await names(page))[2], "slow af5.toml, feed 50 %");
          await button(page, "Run all").click();
          await allRan(page);
          assert.equal((await rows(page)).length, 3);
          // A file that cannot be read is said so, and left as it is.
          await page.evaluate(() => {
            window.studio.documents.put("bad.variants.json", '{"variants": [{"name": "a", "mchine": ""}]}');
            window.studio.store.set("variantsFile", "bad.variants.json");
          });
          await form(page).locator(".fault").filter({ hasText: "bad.variants.json cannot be read: variant 1: unknown key 'mchine'." }).waitFor();
        }),
      )
      .finally(() => rmSync(folder, { recursive: true }));
  },

  "variants of a served folder are saved there, and read from there": (places) =>
    withServed(places, { "part.nc": "G21 G90\nG1 X10 F600\nG1 X20\nM2\n" }, async (page, served) => {
      await tab(page, "Variants");
      await button(page, "Store the current setup").click();
      await button(page, "Copy").click();
      await change(page, "Feed override, %", "200");
      await button(page, "Run all").click();
      await allRan(page);
      const [first, second] = (await rows(page)).map(([, time]) => secondsOf(time));
      assert.ok(second < first, `${first} ${second}`);
      await button(page, "Save").click();
      await page.waitForFunction(() => /Saved: part.variants.json/.test(document.getElementById("bar").innerText), null, { timeout: 10_000 });
      const written = JSON.parse(served.text("part.variants.json"));
      assert.equal(written.variants[1].feed_override_percent, 200);
      await page.reload();
      await page.waitForFunction(() => window.studio?.store.get("run")?.report, null, { timeout: 60_000 });
      await tab(page, "Variants");
      await form(page).getByLabel("Variants file").selectOption("part.variants.json");
      await page.waitForFunction(() => document.querySelectorAll("#side .variant-list tbody tr").length === 2, null, { timeout: 10_000 });
    }),

  "from a block on: what is in force, where the machine stands, and what-if from there": (places) =>
    withPage(places.studio, async (page) => {
      await run(page, { program: "loop.nc", machine: LARGE }, { "loop.nc": LOOP });
      await page.evaluate(() => window.studio.session.change({ dialect: "" }));
      const line = page.locator("#code .cm-line").filter({ hasText: /^G1 Y10 F600$/ }).first();
      await line.click();
      await page.keyboard.press("Control+Shift+Enter");
      const here = form(page).locator(".variant-here");
      await here.getByText("loop.nc, line 11").waitFor();
      const robot = () =>
        page.evaluate(() => {
          const { store } = window.studio;
          const [machine] = store.get("run").robots;
          const blocks = machine.blocks.blocksOfLine(0, 11);
          return { starts: [...blocks].map((each) => machine.blocks.start_s(each)), t_s: store.get("time_s"), end_s: store.get("run").end_s };
        });
      const { starts, t_s, end_s } = await robot();
      assert.equal(starts.length, 3);
      assert.equal(t_s, starts[0]);
      await here.getByLabel("Pass over the line").selectOption({ index: 1 });
      assert.equal((await robot()).t_s, starts[1]);
      await here.locator(".modal").filter({ hasText: /G91.*F1500.*by the text above/s }).waitFor();
      const facts = await here.locator(".figure").allInnerTexts();
      const tip = facts.find((text) => text.startsWith("TCP")).match(/-?\d+\.\d+/g).map(Number);
      near(tip[0], 20, 0.01);
      near(tip[1], 10, 0.01);

      await here.getByRole("button", { name: "Make a variant from here" }).click();
      await change(page, "Feed override, %", "200");
      await button(page, "Store the current setup").click();
      await button(page, "Run all").click();
      await allRan(page);
      const saved = (await listFile(page)).variants[0];
      assert.deepEqual(saved.from, { file: "loop.nc", line: 11, pass: 2 });
      const [, counted] = (await rows(page))[0];
      assert.match(counted, /^\S+ s from line 11 on, \S+ s in total$/);
      assert.ok(secondsOf(counted) < end_s - starts[1], "with twice the feed the rest is sooner over");
      await compared(page, "current setup", "from line 11");
      const said = await saidOf(page);
      assert.match(said, /^From line 11 on: “from line 11” is \S+ s \(\S+ %\) faster: \S+ s against \S+ s of “current setup”\./);
      near(secondsOf(/against (\S+ s)/.exec(said)[1]), end_s - starts[1], 0.0006);
      near(secondsOf(/faster: (\S+ s)/.exec(said)[1]), secondsOf(counted), 0.0006);
      assert.match(said, /it runs from its start with the setup of the variant/);
      const lines = await form(page).locator(".variant-compare .differences tbody td:first-child").allInnerTexts();
      assert.ok(lines.every((text) => !/pass 1 of/.test(text)), `${lines}`);

      // Lines of a changed text have moved.
      await page.evaluate((text) => window.studio.documents.put("loop.nc", `(one more)\n${text}`), LOOP);
      await here.getByRole("button", { name: "Make a variant from here" }).click();
      assert.equal(await state(page, "notice"), "The displayed run is of an earlier loop.nc: run it first");
      await page.evaluate((text) => window.studio.documents.put("loop.nc", text), LOOP);

      // A line without motion is reported as such.
      await page.locator("#code .cm-line").filter({ hasText: /^M99$/ }).first().click();
      await here.getByText(/line 13\. The displayed run has no block of this line/).waitFor();
      assert.equal(await here.getByRole("button", { name: "Make a variant from here" }).isVisible(), false);
    }),
};

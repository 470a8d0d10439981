// Late data (responses of the engine, texts of a folder) changes only the object that it was requested for.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { withServed } from "../served.mjs";
import { dropFiles, run, setState, state, withPage } from "../steps.mjs";

const ROUTER = "samples/machines/router3.toml";
const UNLIMITED = "samples/machines/unlimited.toml";
const DATA = "NCFILE\nOFFSET\n54 1 2 3\nENDFILE\n";
const OTHER_DATA = "NCFILE\nOFFSET\n54 7 8 9\nENDFILE\n";

const tab = (page, name) => page.locator("#side").getByRole("tab", { name, exact: true }).first().click();
const button = (page, name) => page.locator("#side").getByRole("button", { name, exact: typeof name === "string" }).locator("visible=true").first();
const textOf = (page, name) => page.evaluate((of) => window.studio.documents.text(of), name);
const undoLabel = (page) => page.evaluate(() => window.studio.session.history.undoLabel);
const change = (page, setup) => page.evaluate((to) => window.studio.session.change(to), setup);

/**
 * Delays the engine's response to a request of this kind until `act` is done; then waits until it has been
 * delivered.
 */
async function answeredLate(page, kind, ask, act) {
  await page.evaluate((held) => {
    const { session } = window.studio;
    const { sendRequest } = session;
    const late = (window.late = { asked: 0, told: 0 });
    const isLetGo = new Promise((letGo) => (late.letGo = letGo));
    session.sendRequest = async (request, ...more) => {
      const response = await sendRequest.call(session, request, ...more);
      if (request.do !== held) return response;
      ++late.asked;
      await isLetGo;
      setTimeout(() => ++late.told); // after all others that waited for it
      return response;
    };
    late.end = () => (session.sendRequest = sendRequest);
  }, kind);
  await ask();
  await page.waitForFunction(() => window.late.asked > 0);
  await act();
  await page.evaluate(() => (window.late.letGo(), window.late.end()));
  await page.waitForFunction(() => window.late.told === window.late.asked);
}

/** Values of the axes as they are moved, by letter. */
const values = (page) =>
  page.evaluate(() => {
    const { axes } = window.studio.store.get("run").robots[0].scene;
    const jog = window.studio.store.get("jog");
    return Object.fromEntries(axes.map(({ letter, rotary, zero }, i) => [letter, zero + (rotary ? (jog[i] * 180) / Math.PI : jog[i])]));
  });

/** A page that runs with data of the control, of which the only entry is chosen; others are there. */
const withData = (places, test) =>
  withPage(places.studio, async (page) => {
    await run(page, { program: "a.nc", machine_data: "own.txt" }, { "a.nc": "G21 G90 G54\nG1 X10 F600\nM2\n", "own.txt": DATA, "other.txt": OTHER_DATA });
    await tab(page, "Data");
    await page.locator("#side .data-form tbody tr").click();
    await test(page);
  });

/**
 * Opens a page that runs on a machine, its form, and a function that changes the speed of its first axis; the
 * machine is an own file.
 */
const withMachine = (places, machine, test) =>
  withPage(places.studio, async (page) => {
    const own = readFileSync(join(places.samples, "../", ROUTER), "utf8");
    await run(page, { program: "move.nc", machine }, { "move.nc": "G21 G90\nG0 X500\nM30\n", "mine.toml": own });
    await tab(page, "Machine");
    const card = page.locator(".machine-form details.card").first();
    await card.locator("summary").first().click();
    const field = card.getByLabel("Max speed", { exact: true }).locator("visible=true");
    await test(page, async () => {
      await field.fill("100");
      await field.press("Tab");
    });
  });

export default {
  "an answer that comes late moves neither the run nor what has been moved since, nor another run's machine": (places) =>
    withPage(places.studio, async (page) => {
      await setState(page, "time_s", 60);
      await tab(page, "Teach");
      const along = () => button(page, "TCP along X of the work +").click();
      const begun = await values(page);
      await answeredLate(page, "pose", along, () => tab(page, "Run"));
      assert.equal(await state(page, "jog"), null, "the run is shown");
      await tab(page, "Teach");
      assert.deepEqual(await values(page), begun);

      // By hand meanwhile.
      await answeredLate(page, "pose", along, () => button(page, /^Y \+/).click());
      const { X, Y } = await values(page);
      assert.deepEqual([X, Math.round(1e6 * (Y - begun.Y))], [begun.X, 10e6]);

      // For another run the machine stays, and the panel shows a message.
      const at = await values(page);
      await answeredLate(page, "pose", along, () => page.evaluate(() => window.studio.session.run()));
      assert.deepEqual(await values(page), at);
      const jog = await state(page, "jog");
      assert.equal(await page.locator("#side .teach .said").textContent(), "Another run is shown now: nothing has moved.");
      await along();
      await page.waitForFunction(([before]) => window.studio.store.get("jog")[0] !== before, jog, { timeout: 20_000 });

      // A held button continues after the joints have disappeared.
      const { x, y } = await button(page, /^Z −/).boundingBox();
      await page.mouse.move(x + 5, y + 5);
      await page.mouse.down();
      await page.waitForTimeout(500);
      await page.evaluate(() => window.studio.store.set("form", "paths"));
      await page.waitForTimeout(500);
      assert.equal(await state(page, "jog"), null);
      await page.mouse.up();
    }),

  "of a drawing whose dialog is closed meanwhile no path is made": (places) =>
    withPage(places.studio, async (page) => {
      await dropFiles(page, join(places.samples, "plate.svg"));
      const dialog = page.getByRole("dialog", { name: "Path from drawing" });
      await dialog.waitFor();
      await dialog.getByLabel("Material").selectOption("aluminum");
      await dialog.getByLabel("Thickness").fill("12");
      await dialog.getByLabel("Thickness").press("Tab");
      const make = () => dialog.getByRole("button", { name: "Make path" }).click();
      const label = await undoLabel(page);
      await answeredLate(page, "drawing", make, () => dialog.getByRole("button", { name: "Cancel" }).click());
      assert.deepEqual([await state(page, "path"), await undoLabel(page)], [null, label]);
    }),

  "where other data are chosen meanwhile both files stay as they are, and that is said": (places) =>
    withData(places, async (page) => {
      await answeredLate(page, "data", () => button(page, "Reset").click(), () => change(page, { machine_data: "other.txt" }));
      await page.locator("#side .data-form tbody tr").filter({ hasText: "7" }).waitFor();
      assert.deepEqual([await textOf(page, "own.txt"), await textOf(page, "other.txt")], [DATA, OTHER_DATA]);
      assert.equal(await state(page, "notice"), "Other data are selected now: neither they nor own.txt were changed");
    }),

  "Save is of the data that were shown, also where others are chosen before a change of them is made": (places) =>
    withData(places, async (page) => {
      const act = async () => {
        await button(page, "Reset").click();
        await button(page, "Save").click();
      };
      const downloading = page.waitForEvent("download");
      await answeredLate(page, "data", act, () => change(page, { machine_data: "other.txt" }));
      assert.equal((await downloading).suggestedFilename(), "own.txt");
    }),

  "where another machine is chosen meanwhile neither is changed, and that is said": (places) =>
    withMachine(places, ROUTER, async (page, speed) => {
      await answeredLate(page, "toml", speed, () => change(page, { machine: UNLIMITED }));
      await page.waitForFunction(() => /^Another file is shown now/.test(window.studio.store.get("notice")));
      const [machine, own] = await page.evaluate(() => [window.studio.session.setup.machine, window.studio.documents.userFileNames()]);
      assert.deepEqual([machine, own], [UNLIMITED, ["move.nc", "mine.toml"]]);
    }),

  "Save is of the machine that was shown, also where another is chosen before a change of it is made": (places) =>
    withMachine(places, "mine.toml", async (page, speed) => {
      const act = async () => {
        await speed();
        await button(page, "Save").click();
      };
      const downloading = page.waitForEvent("download");
      await answeredLate(page, "toml", act, () => change(page, { machine: UNLIMITED }));
      assert.equal((await downloading).suggestedFilename(), "mine.toml");
    }),

  "a new machine that is still being made is not taken for one of another kind": (places) =>
    withPage(places.studio, async (page) => {
      await tab(page, "Machine");
      await button(page, "New machine…").click();
      const dialog = page.getByRole("dialog", { name: "New machine" });
      const take = dialog.locator("button.primary");
      await page.waitForFunction(() => !document.querySelector("dialog.wizard button.primary").disabled, null, { timeout: 20_000 });
      const name = await dialog.locator(".file b").textContent();
      const other = () => dialog.getByLabel("Kind").selectOption({ index: 3 });
      await answeredLate(page, "toml", other, async () => assert.equal(await take.isDisabled(), true));
      await page.waitForFunction((before) => document.querySelector("dialog.wizard .file b").textContent !== before, name, { timeout: 20_000 });
    }),

  "the reach that is shown is that of the machine that was chosen last": (places) =>
    withPage(places.studio, async (page) => {
      // The first machine has no reach to show, which is reported after another machine has been chosen.
      await page.evaluate(() => {
        const { session, store } = window.studio;
        const tell = (window.tell = []);
        session.envelope = () => new Promise((told) => tell.push(() => told(null)));
        store.set("showEnvelope", true);
        session.change({ feed_override_percent: 90 });
        tell[0]();
      });
      await page.waitForTimeout(100);
      const said = page.locator("#view").getByText("The reach of this machine is unknown.");
      assert.equal(await said.isVisible(), false);
      await page.evaluate(() => window.tell[1]());
      await said.waitFor();
    }),

  "what is in force at a line is not told when that line is no longer chosen": (places) =>
    withPage(places.studio, async (page) => {
      await page.evaluate(() => {
        const { session } = window.studio;
        const { activeSettingsAt } = session;
        const isLetGo = new Promise((letGo) => (window.letGo = letGo));
        window.told = 0;
        session.activeSettingsAt = async (...place) => {
          const found = await activeSettingsAt.call(session, ...place);
          await isLetGo;
          setTimeout(() => ++window.told); // after others that waited for it
          return found;
        };
      });
      await tab(page, "Variants");
      await page.locator("#code .cm-line").filter({ hasText: /^N?\d*\s*G/ }).first().click();
      await page.evaluate(() => (window.studio.store.set("selection", null), window.letGo()));
      await page.waitForFunction(() => window.told > 0);
      assert.equal(await page.locator("#side .variant-here .modal").textContent(), "");
    }),

  "files that are read behind a run are no others by that, until they change on the disk": (places) =>
    withServed(
      places,
      { "part.nc": "G21 G90\nG1 X10 F600\nM2\n", "m.toml": readFileSync(join(places.samples, "machines/router3.toml"), "latin1"), "one.toml": "a = 1\n", "two.toml": "a = 1\n" },
      async (page, served) => {
        await page.evaluate(async () => {
          const { session, store } = window.studio;
          session.change({ machine: "m.toml" });
          await session.run();
          window.ran = store.get("run");
        });
        const changed = () => page.evaluate(() => window.studio.session.changedSince(window.ran));
        const becomes = (names) =>
          page.waitForFunction((expectedValue) => String(window.studio.session.changedSince(window.ran).sort()) === expectedValue, String(names), { timeout: 10_000 });
        const has = (name) => page.evaluate((of) => window.studio.documents.own(of) !== undefined, name);
        assert.deepEqual([await has("one.toml"), await has("two.toml"), await changed()], [false, false, []]);
        served.write("two.toml", "a = 2\n");
        await page.evaluate(() => window.letGo());
        await page.waitForFunction(() => ["one.toml", "two.toml"].every((name) => window.studio.documents.own(name)), null, { timeout: 10_000 });
        await becomes(["two.toml"]);
        served.write("one.toml", "a = 3\n");
        await becomes(["one.toml", "two.toml"]);
      },
      {
        before: {
          script: () => {
            const { fetch } = window;
            const isLetGo = new Promise((letGo) => (window.letGo = letGo));
            window.fetch = async (address, ...more) => {
              if (/file\/(one|two)\.toml$/.test(String(address))) await isLetGo;
              return fetch(address, ...more);
            };
          },
        },
      },
    ),
};

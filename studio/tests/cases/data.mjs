// The control's data: the form changes them, the program runs with them, and they are saved and opened.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { withServed } from "../served.mjs";
import { run, setState, untilSettled, state, withPage } from "../steps.mjs";

const JET = "samples/jet.txt";
const VICE = "NCFILE\r\nOFFSET\r\n54 1 2 3 # left vice\r\nENDFILE\r\n";
const SQUARE = "G21 G90 G94 G54\nG1 X100 Y50 Z20 F6000\nG1 X200\nG1 Y150\nM2\n";

const form = (page) => page.locator("#side .data-form");
const files = (page) => form(page).getByRole("combobox", { name: "Machine data" });
const list = (page) => form(page).getByRole("combobox", { name: "Stored data of the controller" });
const dialog = (page) => page.locator("dialog.data-entry");
const field = (page, name) => dialog(page).getByLabel(name, { exact: true });
const row = (page, id) =>
  form(page).locator("tbody tr").filter({ has: page.getByRole("rowheader", { name: id, exact: true }) });
/** What the rows of the table read. */
const rows = (page) =>
  form(page).locator("tbody tr").evaluateAll((all) => all.map((each) => [...each.children].map((cell) => cell.innerText).join(" ")));
const press = (page, name) => form(page).getByRole("button", { name, exact: true }).click();
const textOf = (page, name) => page.evaluate((of) => window.studio.documents.text(of), name);
const undoLabel = (page) => page.evaluate(() => window.studio.session.history.undoLabel);
const focused = (page) => page.evaluate(() => document.activeElement.innerText.split(/[\t\n]/)[0]);

/** Returns the path of the TCP, without the start of the run. */
const way = (page) =>
  page.evaluate(() => window.studio.store.get("run").robots[0].segments.sections.flatMap((section) => [...section.vertex_mm]).slice(3));

/** Waits until the run that is shown is another one, as `act` brings it about. */
async function runAnew(page, act) {
  await page.evaluate(() => (window.shownBefore = window.studio.store.get("run")));
  await act();
  await page.waitForFunction(() => window.studio.store.get("run") !== window.shownBefore, null, { timeout: 20_000 });
}

/** Waits until the table has a row that reads so. */
async function waitForRow(page, text) {
  for (const until = Date.now() + 10_000; Date.now() < until; await page.waitForTimeout(50)) {
    if ((await rows(page)).includes(text)) return;
  }
  assert.fail(`no row reads '${text}', but ${(await rows(page)).join("; ")}`);
}

/** Opens a page with the square run and the form, with the machine data of a text, if any. */
const withForm = (places, test, text = "") =>
  withPage(places.studio, async (page) => {
    const setup = { program: "square.nc", ...(text ? { machine_data: "own.txt" } : {}) };
    const { status } = await run(page, setup, { "square.nc": SQUARE, ...(text ? { "own.txt": text } : {}) });
    assert.equal(status, "completed");
    await page.getByRole("tab", { name: "Data" }).click();
    await page.waitForFunction(() => document.querySelectorAll("#side .data-section option").length > 0);
    await test(page);
  });

/** Returns the constant offset of one path from another. */
function shift(before, after) {
  assert.equal(after.length, before.length);
  const by = [0, 1, 2].map((i) => after[i] - before[i]);
  const off = before.findIndex((value, i) => Math.abs(after[i] - value - by[i % 3]) > 1e-3);
  assert.equal(off, -1, `coordinate ${off} goes from ${before[off]} to ${after[off]}`);
  return by.map((value) => Math.round(1000 * value) / 1000);
}

async function addOffset(page, id, values) {
  await press(page, "Add…");
  await page.getByLabel("Number or name").fill(id);
  for (const [name, value] of Object.entries(values)) await field(page, name).fill(value);
  await page.keyboard.press("Enter");
}

async function download(page, act) {
  const downloading = page.waitForEvent("download");
  await act();
  const file = await downloading;
  return { name: file.suggestedFilename(), bytes: readFileSync(await file.path()) };
}

const fileOf = (name, content) => ({ name, mimeType: "text/plain", buffer: Buffer.from(content) });

async function openData(page, file) {
  const chooser = page.waitForEvent("filechooser");
  await press(page, "Open…");
  await (await chooser).setFiles(file);
}

export default {
  "an offset in the form moves the way by as much, saved and opened elsewhere, too": async (places) => {
    let saved, moved;
    await withForm(places, async (page) => {
      const before = await way(page);
      await runAnew(page, () => addOffset(page, "54", { X: "10" }));
      assert.deepEqual(shift(before, await way(page)), [10, 0, 0]);
      assert.equal(await page.evaluate(() => window.studio.session.setup.machine_data), "shop.txt");
      assert.deepEqual(await rows(page), ["54 10 0 0 mm"]);
      assert.match(await page.locator("#bar summary").textContent(), /More \(1\)/);

      await row(page, "54").dblclick();
      await field(page, "Y").fill("-2.5");
      await runAnew(page, () => dialog(page).getByRole("button", { name: "OK" }).click());
      moved = await way(page);
      assert.deepEqual(shift(before, moved), [10, -2.5, 0]);
      assert.equal(await dialog(page).count(), 0);
      assert.equal(await page.evaluate(() => window.studio.documents.unsaved), true);
      saved = await download(page, () => press(page, "Save"));
      assert.equal(await page.evaluate(() => window.studio.documents.isUnsaved("shop.txt")), false);
    });
    assert.equal(saved.name, "shop.txt");
    assert.match(saved.bytes.toString(), /^NCFILE\nOFFSET\n54 +10 +-2\.5 +0\nENDFILE\n$/);
    await withForm(places, async (page) => {
      assert.notDeepEqual(await way(page), moved);
      await runAnew(page, () => openData(page, fileOf(saved.name, saved.bytes)));
      assert.deepEqual(await way(page), moved);
      await waitForRow(page, "54 10 -2.5 0 mm");
    });
  },

  "changes are taken back and done again by keys and buttons, with their runs": (places) =>
    withForm(places, async (page) => {
      const before = await way(page);
      await runAnew(page, () => addOffset(page, "54", { X: "10" }));
      await row(page, "54").press("Enter");
      await field(page, "X").fill("30");
      await runAnew(page, () => page.keyboard.press("Enter"));
      assert.deepEqual(shift(before, await way(page)), [30, 0, 0]);
      assert.equal(await page.locator("#undo-button").getAttribute("title"), "Undo: OFFSET 54 (Ctrl+Z)");
      await waitForRow(page, "54 30 0 0 mm");
      await row(page, "54").focus();
      await runAnew(page, () => page.keyboard.press("Control+z"));
      assert.deepEqual(shift(before, await way(page)), [10, 0, 0]);
      await waitForRow(page, "54 10 0 0 mm");
      assert.equal(await focused(page), "54");
      await runAnew(page, () => page.locator("#undo-button").click());
      assert.deepEqual(shift(before, await way(page)), [0, 0, 0]);
      assert.equal(await page.evaluate(() => window.studio.session.setup.machine_data), "");
      assert.equal(await page.evaluate(() => window.studio.documents.get("shop.txt")), undefined);
      await page.waitForFunction(() => document.querySelectorAll("#side .data-form tbody tr").length === 0);
      await runAnew(page, () => page.keyboard.press("Control+Shift+Z"));
      assert.deepEqual(shift(before, await way(page)), [10, 0, 0]);
      await runAnew(page, () => page.locator("#redo-button").click());
      assert.deepEqual(shift(before, await way(page)), [30, 0, 0]);
    }),

  "lengths are entered in mm or inch, and rows and the whole file turned into the other": (places) =>
    withForm(
      places,
      async (page) => {
        const before = await way(page);
        await row(page, "54").dblclick();
        assert.equal(await field(page, "X").inputValue(), "25.4");
        await field(page, "Z").fill("3");
        await field(page, "inch").check();
        assert.deepEqual([await field(page, "X").inputValue(), await field(page, "Z").inputValue()], ["1", "3"]);
        await field(page, "X").fill("2");
        await field(page, "Z").fill("0");
        await runAnew(page, () => page.keyboard.press("Enter"));
        assert.deepEqual(shift(before, await way(page)), [25.4, 0, 0]);
        await waitForRow(page, "54 2 0 0 inch");
        assert.match(await textOf(page, "own.txt"), /^54 +2 +0 +0 +inch +# left vice$/m);

        await runAnew(page, () => row(page, "54").getByRole("button").click());
        await waitForRow(page, "54 50.8 0 0 mm");
        assert.deepEqual(shift(before, await way(page)), [25.4, 0, 0]);

        await runAnew(page, () => press(page, "inch"));
        await waitForRow(page, "54 2 0 0 inch");
        await list(page).selectOption({ label: "Tools" });
        await waitForRow(page, "1 2 0.5 inch");

        // A new entry is in the unit of the page.
        await list(page).selectOption("OFFSET");
        await setState(page, "units", "inch");
        await addOffset(page, "55", { X: "1" });
        await waitForRow(page, "55 1 0 0 inch");
      },
      "NCFILE\nOFFSET\n54 25.4 0 0 # left vice\nTOOL\n1 50.8 12.7\nENDFILE\n",
    ),

  "what is refused is said at its field, and changes nothing": (places) =>
    withForm(
      places,
      async (page) => {
        const before = await textOf(page, "own.txt");
        const faultOf = async (name) => {
          const input = field(page, name);
          const about = await input.getAttribute("aria-describedby");
          const texts = await Promise.all(about.split(" ").map((id) => page.locator(`[id="${id}"]`).innerText()));
          return [await input.getAttribute("aria-invalid"), texts.at(-1)];
        };
        await row(page, "54").dblclick();
        await field(page, "X").fill("5");
        await field(page, "Y").fill("3,5");
        await page.keyboard.press("Enter");
        await dialog(page).getByText("'3,5' is not a number").waitFor();
        assert.deepEqual(await faultOf("Y"), ["true", "'3,5' is not a number"]);
        assert.deepEqual(await faultOf("X"), ["false", ""]);
        assert.equal(await page.evaluate(() => document.activeElement.id), "data-entry-Y");
        assert.deepEqual([await textOf(page, "own.txt"), await undoLabel(page)], [before, ""]);
        await page.keyboard.press("Escape");
        assert.equal(await focused(page), "54");
        assert.deepEqual([await textOf(page, "own.txt"), await undoLabel(page)], [before, ""]);

        await addOffset(page, "60", { X: "5" });
        await dialog(page).getByText(/'60' is not a frame/).waitFor();
        assert.equal((await faultOf("Number or name"))[0], "true");
        await field(page, "Number or name").fill("54");
        await page.keyboard.press("Enter");
        await dialog(page).getByText(/54 exists already/).waitFor();
        await field(page, "Number or name").fill("");
        await page.keyboard.press("Enter");
        await dialog(page).getByText(/needs its number/).waitFor();
        await dialog(page).getByRole("button", { name: "Cancel" }).click();
        assert.deepEqual([await textOf(page, "own.txt"), await undoLabel(page)], [before, ""]);

        await list(page).selectOption("SECURITY");
        await row(page, "1").dblclick();
        await field(page, "XMAX").fill("-5");
        await page.keyboard.press("Enter");
        await dialog(page).getByText(/min must be less than max/).waitFor();
        assert.equal((await faultOf("XMAX"))[0], "true");
        await field(page, "XMAX").fill("520");
        await field(page, "STATE").selectOption("OFF");
        await page.keyboard.press("Enter");
        await dialog(page).waitFor({ state: "detached" });
        assert.match(await textOf(page, "own.txt"), /^1 +500 +520 +0 +10 +OFF$/m);
      },
      "NCFILE\nOFFSET\n54 1 2 3\nSECURITY\n1 500 510 0 10\nENDFILE\n",
    ),

  "an entry, or all of a list, is reset; an alias goes away": (places) =>
    withForm(
      places,
      async (page) => {
        await row(page, "55").click();
        await press(page, "Reset");
        await waitForRow(page, "55 0 0 0 mm");
        assert.deepEqual(await rows(page), ["54 1 2 3 mm", "55 0 0 0 mm", "56 7 8 9 mm"]);
        await press(page, "Reset all");
        await waitForRow(page, "56 0 0 0 mm");
        assert.deepEqual(await rows(page), ["54 0 0 0 mm", "55 0 0 0 mm", "56 0 0 0 mm"]);
        assert.match(await textOf(page, "own.txt"), /^54 +0 +0 +0 +# left vice$/m);
        await page.keyboard.press("Control+z");
        await waitForRow(page, "56 7 8 9 mm");

        await list(page).selectOption({ label: "Aliases" });
        await row(page, "JetOn").click();
        await page.keyboard.press("Delete");
        await row(page, "JetOn").waitFor({ state: "detached" });
        assert.deepEqual(await rows(page), ["JetOff M09"]);
        assert.equal(await focused(page), "JetOff");
        await page.keyboard.press("Delete");
        await row(page, "JetOff").waitFor({ state: "detached" });
        assert.equal(await focused(page), "Add…");
        assert.match(await form(page).innerText(), /No entries/);
        // The others are as they were.
        await list(page).selectOption("OFFSET");
        assert.deepEqual(await rows(page), ["54 1 2 3 mm", "55 0 0 0 mm", "56 7 8 9 mm"]);
      },
      "NCFILE\nOFFSET\n54 1 2 3 # left vice\n55 4 5 6\n56 7 8 9\nALIAS\nJetOn M08\nJetOff M09\nENDFILE\n",
    ),

  "arrows go through the rows, Enter changes the one that has the focus": (places) =>
    withForm(
      places,
      async (page) => {
        await row(page, "54").focus();
        await page.keyboard.press("ArrowDown");
        assert.equal(await focused(page), "55");
        assert.equal(await row(page, "55").getAttribute("aria-selected"), "true");
        await page.keyboard.press("End");
        await page.keyboard.press("ArrowUp");
        await page.keyboard.press("ArrowUp");
        await page.keyboard.press("Enter");
        await dialog(page).getByRole("heading", { name: "54" }).waitFor();
        await page.keyboard.type("8");
        await page.keyboard.press("Enter");
        await waitForRow(page, "54 8 2 3 mm");
        assert.equal(await focused(page), "54");
        assert.equal(await form(page).locator("tbody tr[tabindex='0']").count(), 1);
      },
      "NCFILE\nOFFSET\n54 1 2 3\n55 4 5 6\n56 7 8 9\nENDFILE\n",
    ),

  "what is suspect is shown, and what is wrong with a file": (places) =>
    withForm(places, async (page) => {
      await openData(page, fileOf("far.txt", "NCFILE\nOFFSET\n54 99999 0 0\nENDFILE\n"));
      await form(page).locator(".problems .warning").waitFor();
      assert.match(await form(page).locator(".problems").innerText(), /line 3.*99999/s);
      await row(page, "54").click();
      await page.keyboard.press("Delete");
      await form(page).locator(".problems .warning").waitFor({ state: "detached" });

      await openData(page, fileOf("broken.txt", "NCFILE\nOFFSET\n54 1 2\n55 a 2 3\nENDFILE\n"));
      await form(page).locator(".problems .error").first().waitFor();
      const said = await form(page).locator(".problems").innerText();
      assert.match(said, /broken\.txt cannot be read/);
      assert.match(said, /line 4\s+'a' is not a number/);
      assert.equal(await form(page).locator("table").isVisible(), false);
      await page.locator("#undo-button").click();
      await waitForRow(page, "54 0 0 0 mm");

      await openData(page, fileOf("part.txt", "G0 X1\n"));
      await page.waitForFunction(() => /part\.txt is not machine data/.test(window.studio.store.get("notice")));
      assert.equal(await page.evaluate(() => window.studio.session.setup.machine_data), "far.txt");
      assert.equal(await page.evaluate(() => window.studio.documents.get("part.txt")), undefined);
    }),

  "all that a control stores is in the list, with a field for each value": (places) =>
    withForm(places, async (page) => {
      await runAnew(page, () => files(page).selectOption(JET));
      const lists = await list(page).locator("option").evaluateAll((all) => all.map(({ value }) => value));
      assert.deepEqual(lists, ["OFFSET", "FIXED", "REFERENCE", "HOME", "TOOL", "VARIABLE", "ALIAS", "SECURITY", "WORKING"]);
      const first = {};
      for (const name of lists) {
        await list(page).selectOption(name);
        [first[name]] = await rows(page);
      }
      assert.deepEqual(first, {
        OFFSET: "54 200.0001 200.0002 200 mm",
        FIXED: "1 0 0 0 mm",
        REFERENCE: "1 914.4 1219.2 0 MIDDLE mm",
        HOME: "2 100 100 600 0 0 mm",
        TOOL: "1 50.8 1.016  JET mm",
        VARIABLE: "500 0",
        ALIAS: "WaterJetOn M08",
        SECURITY: "1 1700 1828.8 2300 2438.4   ENTER   mm",
        WORKING: "1 0 1828.8 0 2438.4 0 609.6 mm",
      });
      await list(page).selectOption("TOOL");
      await row(page, "2").dblclick();
      assert.equal(await field(page, "DIAMETER_WEAR").inputValue(), "0.02");
      assert.equal(await field(page, "KIND").inputValue(), "JET");
      await field(page, "KIND").selectOption("CUTTER");
      await field(page, "ORIENTATION").fill("3");
      await page.keyboard.press("Enter");
      await dialog(page).waitFor({ state: "detached" });
      assert.match(await textOf(page, JET), /^2 +50\.8 +0\.762 +CUTTER +DIAMETER_WEAR=0\.02 +ORIENTATION=3$/m);
      // Other lines are unchanged.
      assert.match(await textOf(page, JET), /^54 +200\.0001 +200\.0002 +200 +# the example of the thesis/m);
    }),

  "in a folder data are saved beside the program": (places) =>
    withServed(places, { "part.nc": SQUARE, "data.txt": VICE }, async (page, served) => {
      await page.getByRole("tab", { name: "Data" }).click();
      await runAnew(page, () => files(page).selectOption("data.txt"));
      await row(page, "54").dblclick();
      await field(page, "X").fill("7");
      await runAnew(page, () => page.keyboard.press("Enter"));
      assert.match(served.text("data.txt"), /54 1 2 3/);
      await press(page, "Save");
      await page.waitForFunction(() => window.studio.store.get("notice") === "Saved: data.txt");
      assert.equal(served.text("data.txt"), VICE.replace("54 1", "54 7"));
      await setState(page, "notice", "");
      await row(page, "54").click();
      await form(page).evaluate((element) => {
        for (const text of ["Reset", "Save"]) [...element.querySelectorAll("button")].find((each) => each.innerText === text).click();
      });
      await page.waitForFunction(() => window.studio.store.get("notice") === "Saved: data.txt");
      assert.match(served.text("data.txt"), /^54 0 0 0 # left vice/m, "what was pressed just before is saved, too");
      await files(page).selectOption("");
      await form(page).getByText("No entries").waitFor();
      await addOffset(page, "55", { Y: "4" });
      await waitForRow(page, "55 0 4 0 mm");
      await press(page, "Save");
      await page.waitForFunction(() => window.studio.store.get("notice") === "Saved: shop.txt");
      assert.match(served.text("shop.txt"), /^NCFILE\nOFFSET\n55 +0 +4 +0\nENDFILE\n$/);
    }),

  "the form keeps the focus, and its picture is that of the documentation": (places) =>
    withPage(places.studio, async (page) => {
      await page.getByRole("tab", { name: "Data" }).click();
      await runAnew(page, () => files(page).selectOption(JET));
      await list(page).focus();
      await page.evaluate((name) => {
        const { session, documents } = window.studio;
        session.history.edit("elsewhere", { documents: { [name]: documents.text(name).replace("57     0", "57     1") } });
      }, JET);
      await waitForRow(page, "57 1 0 0 mm");
      assert.equal(await page.evaluate(() => document.activeElement.className), "data-section");
      await page.locator("#undo-button").click();
      await waitForRow(page, "57 0 0 0 mm");
      await row(page, "505").dblclick();
      await field(page, "X").fill("1.5001");
      await setState(page, "time_s", 60);
      await setState(page, "notice", "");
      await untilSettled(page);
      assert.equal(await state(page, "playing"), false);
      const path = join(places.samples, "../docs/images/studio-data.png");
      if (process.env.GSIM_RENEW_PICTURES) await page.screenshot({ path });
    }),
};

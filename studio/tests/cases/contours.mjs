// Contours of a part that is not flat, chosen in their picture. The page that gsim studio serves reads such parts.

import assert from "node:assert/strict";
import { existsSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { withServed } from "../served.mjs";

const PART = "G21 G90\nG1 X10 F600\nM2\n";

/** The dialog for the bracket, with its contours in the picture. */
async function openDialog(page, kind = "holes") {
  const side = page.locator("#side");
  await side.getByRole("tab", { name: "Paths", exact: true }).click();
  await side.getByRole("button", { name: "From drawing…" }).click();
  const dialog = page.getByRole("dialog", { name: "Path from drawing" });
  await dialog.getByLabel("Drawing").selectOption("bracket.step");
  await dialog.getByLabel("Speed, mm/min").fill("400");
  await dialog.getByLabel("Kerf, mm").fill("0.8");
  await dialog.getByLabel("Cut", { exact: true }).selectOption(kind);
  return dialog;
}

const saysCut = (dialog, cut, all) => dialog.getByRole("status").filter({ hasText: `${cut} of ${all} contours are cut.` }).waitFor();

/** Moves the pointer over the picture, row by row, until it is on a contour; returns that position. */
async function pointAtContour(page, dialog) {
  const { x, y, width, height } = await dialog.locator("canvas").boundingBox();
  for (let down = height / 2; down < height; down += 12) {
    for (let right = 4; right < width; right += 12) {
      await page.mouse.move(x + right, y + down);
      if ((await dialog.locator("li.highlighted").count()) > 0) return [x + right, y + down];
    }
  }
  throw new Error("no contour is under the pointer");
}

const withBracket = (places, test) => {
  if (!existsSync(join(places.build, "bin/gsim-solid"))) return console.log("  skipped: there is no OpenCASCADE here");
  const step = readFileSync(join(places.samples, "parts/bracket.step"), "latin1");
  return withServed(places, { "part.nc": PART, "bracket.step": step }, test);
};

/**
 * Delays the engine's responses about contours until go() is called; asked() waits until so many were
 * requested.
 */
async function holdContours(page) {
  const held = { count: 0 };
  const gate = new Promise((go) => (held.go = go));
  await page.route("**/ask", async (route) => {
    if (!route.request().postData()?.includes('"do":"contours"')) return route.fallback();
    ++held.count;
    await gate;
    return route.continue();
  });
  held.asked = async (count) => {
    while (held.count < count) await page.waitForTimeout(20);
  };
  return held;
}

export default {
  "a hole of a bent part is clicked off in its picture, and the path has one contour less": (places) =>
    withBracket(places, async (page) => {
      const dialog = await openDialog(page);
      await saysCut(dialog, 4, 4);
      const rows = dialog.getByRole("list", { name: "Contours of the part" }).getByRole("checkbox");
      assert.equal(await rows.count(), 4);
      const at = await pointAtContour(page, dialog);
      const told = await dialog.locator(".pointed-at").innerText();
      assert.match(told, /^Hole at edge #\d+ of the plane face #\d+ at \(.*\): [\d.]+ mm long, 6\.00 mm deep, tilted by [\d.]+°$/);
      await page.mouse.click(...at);
      await saysCut(dialog, 3, 4);
      assert.equal(await dialog.getByRole("checkbox", { name: told }).isChecked(), false);
      await page.mouse.click(...at);
      await saysCut(dialog, 4, 4);
      await page.mouse.click(...at);
      await saysCut(dialog, 3, 4);
      if (process.env.GSIM_RENEW_PICTURES) await dialog.screenshot({ path: join(places.samples, "../docs/images/studio-contours.png") });
      await dialog.getByRole("button", { name: "Make path" }).click();
      await dialog.waitFor({ state: "detached" });
      await page.locator("#side").getByText(/3 contours, 3 pierces/).waitFor();
      // Removed contours stay removed when the dialog is opened for the part again.
      const again = await openDialog(page);
      await saysCut(again, 3, 4);
      await again.getByRole("button", { name: "All", exact: true }).click();
      await saysCut(again, 4, 4);
    }),

  "contours are chosen and turned by the keyboard, and what the fields choose is read anew": (places) =>
    withBracket(places, async (page) => {
      const dialog = await openDialog(page);
      await saysCut(dialog, 4, 4);
      const canvas = dialog.locator("canvas");
      await canvas.focus();
      await page.keyboard.press("0"); // from the first key on the focus shows
      await page.waitForTimeout(100);
      const first = await canvas.screenshot();
      for (const key of ["ArrowLeft", "ArrowUp", "+"]) await page.keyboard.press(key);
      await page.waitForTimeout(100);
      assert.notDeepEqual(await canvas.screenshot(), first);
      await page.keyboard.press("0");
      await page.waitForTimeout(100);
      assert.deepEqual(await canvas.screenshot(), first);
      const box = dialog.getByRole("list", { name: "Contours of the part" }).getByRole("checkbox").nth(1);
      await box.focus();
      assert.equal(await dialog.locator("li").nth(1).evaluate((row) => row.classList.contains("highlighted")), true);
      await page.keyboard.press("Space");
      await saysCut(dialog, 3, 4);
      assert.equal(await box.evaluate((each) => each === document.activeElement), true);
      await dialog.getByRole("button", { name: "None", exact: true }).click();
      await saysCut(dialog, 0, 4);
      await dialog.getByRole("button", { name: "Make path" }).click();
      await dialog.getByRole("alert").filter({ hasText: "No contour is selected" }).waitFor();
      // Other contours: all are selected, and the response to the last request counts.
      for (const side of ["y", "-z", "z"]) await dialog.getByLabel("Direction of the faces").selectOption(side);
      await saysCut(dialog, 4, 4);
      await dialog.getByLabel("Direction of the faces").selectOption("-z");
      await saysCut(dialog, 4, 4);
      await dialog.getByLabel("Faces", { exact: true }).fill("nowhere");
      await dialog.getByLabel("Faces", { exact: true }).blur();
      await dialog.getByRole("alert").filter({ hasText: "it has no face with the number, name, layer or colour 'nowhere'" }).waitFor();
      assert.equal(await canvas.isVisible(), false);
      await dialog.getByLabel("Cut", { exact: true }).selectOption("");
      assert.equal(await dialog.getByRole("region", { name: "Contours of the part" }).isVisible(), false);
    }),

  "while contours are read the dialog is usable, and an answer that comes too late changes nothing": (places) =>
    withBracket(places, async (page) => {
      const held = await holdContours(page);
      const dialog = await openDialog(page);
      await held.asked(1);
      await dialog.getByRole("status").filter({ hasText: "Reading the part's contours" }).waitFor();
      await dialog.getByLabel("Direction of the faces").selectOption("-z");
      await dialog.getByLabel("Bridges").fill("2");
      held.go();
      await saysCut(dialog, 4, 4);
      assert.equal(held.count, 2);
      const rows = await dialog.locator("li").filter({ has: page.getByRole("checkbox") }).allInnerTexts();
      assert.equal(rows.length, 4);
      // Contours of the faces below, not of those above with the earlier response.
      assert.ok(rows.every((row) => /tilted by/.test(row) && !row.includes("#933 ")), rows.join("\n"));
      assert.equal(await dialog.getByLabel("Bridges").inputValue(), "2");
      await page.unroute("**/ask");
      const late = await holdContours(page);
      await dialog.getByLabel("Direction of the faces").selectOption("z");
      await late.asked(1);
      await dialog.getByRole("button", { name: "Cancel" }).click();
      await dialog.waitFor({ state: "detached" });
      late.go();
      await page.waitForTimeout(500);
      assert.equal(await page.getByRole("dialog").count(), 0);
    }),
};

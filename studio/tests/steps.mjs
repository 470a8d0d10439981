// Common steps of the page tests.

import assert from "node:assert/strict";
import { existsSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { openPage } from "./browser.mjs";

/**
 * Opens a page, waits for its first run, and closes it after `test`; errors fail the test, except for those
 * that are `expected`.
 */
export async function withPage(file, test, { expected, ...options } = {}) {
  const { page, errors, close } = await openPage(file, options);
  try {
    await page.waitForFunction(() => window.studio?.store.get("run")?.report, null, { timeout: 60_000 });
    await test(page);
    assert.deepEqual(errors.filter((error) => !expected?.test(error)), []);
  } finally {
    await close();
  }
}

/** Runs a program on a setup, and waits for its end. */
export const run = (page, setup, files = {}) =>
  page.evaluate(
    async ([change, own]) => {
      const { session, documents, store } = window.studio;
      for (const [name, text] of Object.entries(own)) documents.put(name, text);
      const empty = { program: "", machine: "", dialect: "", cell: "", machine_data: "", robots: "" };
      session.change({ ...empty, ...change });
      await session.run();
      const { report, error } = store.get("run");
      return { status: report?.status, cycle_time_s: report?.cycle_time_s, error: error?.message };
    },
    [setup, files],
  );

export const state = (page, key) => page.evaluate((name) => window.studio.store.get(name), key);
export const setState = (page, key, value) =>
  page.evaluate(([name, to]) => window.studio.store.set(name, to), [key, value]);

/** Waits until the picture of the path is complete and drawing has ended. */
export async function untilSettled(page) {
  await page.waitForFunction(() => window.studio.view?.complete(), null, { timeout: 60_000 });
  await page.waitForTimeout(700);
}

/** Returns the picture of only the machine and the path, because text looks different on each system. */
export async function pictureOfView(page) {
  await untilSettled(page);
  const words = "#view > :not(.surface), #view .surface > :not(canvas) { visibility: hidden !important; }";
  const style = await page.addStyleTag({ content: words });
  const picture = await page.locator("#view canvas").first().screenshot();
  await style.evaluate((element) => element.remove());
  return picture;
}

/** The share of pixels that differ by more than 24 of 255 in a colour. */
export const difference = (page, one, other) =>
  page.evaluate(
    async ([first, second]) => {
      const pixels = async (base64) => {
        const image = new Image();
        image.src = `data:image/png;base64,${base64}`;
        await image.decode();
        const canvas = document.createElement("canvas");
        [canvas.width, canvas.height] = [image.width, image.height];
        const context = canvas.getContext("2d");
        context.drawImage(image, 0, 0);
        return { size: `${image.width}x${image.height}`, data: context.getImageData(0, 0, image.width, image.height).data };
      };
      const [a, b] = [await pixels(first), await pixels(second)];
      if (a.size !== b.size) return 1;
      let off = 0;
      for (let i = 0; i < a.data.length; i += 4) {
        const most = Math.max(...[0, 1, 2].map((c) => Math.abs(a.data[i + c] - b.data[i + c])));
        if (most > 24) ++off;
      }
      return (4 * off) / a.data.length;
    },
    [one.toString("base64"), other.toString("base64")],
  );

/** Returns the number of pixels of the view with a colour that `wanted(r, g, b)`, given as text, accepts. */
export const countPixels = (page, picture, expectedValue) =>
  page.evaluate(
    async ([base64, condition]) => {
      const image = new Image();
      image.src = `data:image/png;base64,${base64}`;
      await image.decode();
      const canvas = document.createElement("canvas");
      [canvas.width, canvas.height] = [image.width, image.height];
      const context = canvas.getContext("2d");
      context.drawImage(image, 0, 0);
      const { data } = context.getImageData(0, 0, image.width, image.height);
      const [channel, least, over] = condition; // the channel is that much above both others
      let count = 0;
      for (let i = 0; i < data.length; i += 4) {
        const others = [0, 1, 2].filter((c) => c !== channel).map((c) => data[i + c]);
        if (data[i + channel] >= least && data[i + channel] - Math.max(...others) >= over) ++count;
      }
      return count;
    },
    [picture.toString("base64"), expectedValue],
  );

/** Max share of pixels that may differ from a kept picture: other renderers smooth edges differently. */
const TOLERANCE = 0.01;

export async function comparePicture(page, places, name) {
  const file = join(places.pictures, `${name}.png`);
  const picture = await pictureOfView(page);
  if (process.env.GSIM_RENEW_PICTURES || !existsSync(file)) {
    assert.ok(process.env.GSIM_RENEW_PICTURES, `there is no ${file}; GSIM_RENEW_PICTURES=1 makes it`);
    writeFileSync(file, picture);
    return;
  }
  const share = await difference(page, picture, readFileSync(file));
  if (share > TOLERANCE) writeFileSync(join(places.build, `${name}.png`), picture);
  assert.ok(share <= TOLERANCE, `${(100 * share).toFixed(2)} % of ${name}.png differ; what it is now lies in ${places.build}`);
}

/** Drops files on the page, as from a folder. */
export async function dropFiles(page, ...files) {
  const session = await page.context().newCDPSession(page);
  const data = { items: [], files, dragOperationsMask: 1 };
  for (const type of ["dragEnter", "dragOver", "drop"]) await session.send("Input.dispatchDragEvent", { type, x: 640, y: 300, data });
}

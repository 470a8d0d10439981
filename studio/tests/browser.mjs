// A page of the studio in Debian's Chromium, without a window.

import { chromium } from "playwright-core";

const EXECUTABLE = process.env.CHROMIUM ?? "/usr/bin/chromium";

/** Opens a file, or an address, in a browser of its own; `before` is run in the page before its own code; what goes wrong in the page is kept in `faults`. */
export async function openPage(file, { width = 1280, height = 800, dark = false, before } = {}) {
  const isAddress = file.startsWith("http:");
  const browser = await chromium.launch({
    executablePath: EXECUTABLE,
    args: ["--no-sandbox", "--enable-unsafe-swiftshader", "--use-gl=angle", "--use-angle=swiftshader"],
  });
  const context = await browser.newContext({ viewport: { width, height }, colorScheme: dark ? "dark" : "light" });
  const page = await context.newPage();
  const faults = [];
  page.on("pageerror", (error) => faults.push(String(error)));
  page.on("console", (message) => {
    if (message.type() === "error") faults.push(message.text());
  });
  page.on("request", (request) => {
    const isOwn = /^(file|blob|data):/.test(request.url()) || (isAddress && request.url().startsWith(file));
    if (!isOwn) faults.push(`asked for ${request.url()}`);
  });
  if (before) await page.addInitScript(before.script, before.argument);
  await page.goto(isAddress ? file : `file://${file}`);
  return { browser, page, faults };
}

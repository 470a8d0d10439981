// A page of the studio in Debian's Chromium, without a window.

import { chromium } from "playwright-core";

const EXECUTABLE = process.env.CHROMIUM ?? "/usr/bin/chromium";

const idle = [];
const open = new Set();

// A start takes two seconds of processor time.
async function takeBrowser() {
  for (let browser = idle.pop(); browser; browser = idle.pop()) if (browser.isConnected()) return browser;
  return chromium.launch({
    executablePath: EXECUTABLE,
    args: ["--no-sandbox", "--enable-unsafe-swiftshader", "--use-gl=angle", "--use-angle=swiftshader"],
  });
}

/** Ends the idle browsers of closed pages. */
export const closeBrowsers = () => Promise.all(idle.splice(0).map((browser) => browser.close()));

/** What the pages say that are open, for the case that waits for one of them. */
export async function whatIsOpen() {
  const said = async (page) => {
    const patience = new Promise((done) => setTimeout(done, 5000, "does not answer"));
    const words = page.evaluate(() => [document.getElementById("bar"), ...document.querySelectorAll("dialog")].map((each) => each?.innerText));
    return `  a page: ${JSON.stringify(await Promise.race([words, patience]).catch(String))}`;
  };
  return open.size > 0 ? (await Promise.all([...open].map(said))).join("\n") : "  no page is open";
}

/**
 * Opens a file, or an address, in a window that shares nothing with others: storage, caches, and, while it is
 * open, its browser. `before` runs in the page before its own code; errors in the page are stored in
 * `errors`.
 */
export async function openPage(file, { width = 1280, height = 800, dark = false, before } = {}) {
  const isAddress = file.startsWith("http:");
  const browser = await takeBrowser();
  const context = await browser.newContext({ viewport: { width, height }, colorScheme: dark ? "dark" : "light" });
  const page = await context.newPage();
  open.add(page);
  const errors = [];
  page.on("pageerror", (error) => errors.push(String(error)));
  page.on("console", (message) => {
    if (message.type() === "error") errors.push(message.text());
  });
  page.on("request", (request) => {
    const isOwn = /^(file|blob|data):/.test(request.url()) || (isAddress && request.url().startsWith(file));
    if (!isOwn) errors.push(`asked for ${request.url()}`);
  });
  if (before) await page.addInitScript(before.script, before.argument);
  // Long timeout for a busy machine: the load time of a page is a topic of the benchmarks.
  await page.goto(isAddress ? file : `file://${file}`, { timeout: 180_000 });
  const close = async () => {
    open.delete(page);
    await context.close();
    idle.push(browser);
  };
  return { page, errors, close };
}

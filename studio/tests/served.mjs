// Separate folder, and gsim-studio with a page for it.

import { spawn } from "node:child_process";
import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { createInterface } from "node:readline";
import { within } from "./patience.mjs";
import { withPage } from "./steps.mjs";

const PATIENCE_MS = 20_000;

/** The address that a program says first. */
function addressOf(program) {
  return new Promise((tell, fail) => {
    const patience = setTimeout(() => fail(new Error("gsim-studio says no address")), PATIENCE_MS);
    program.on("exit", (status) => fail(new Error(`gsim-studio has ended with ${status}`)));
    createInterface(program.stdout).once("line", (line) => {
      clearTimeout(patience);
      tell(line.trim());
    });
  });
}

/** What is in a served folder, and the server. */
class Served {
  constructor(folder, program) {
    Object.assign(this, { folder, program });
  }

  path(name) {
    return join(this.folder, name);
  }

  text(name) {
    return readFileSync(this.path(name), "latin1");
  }

  /** As another program does. */
  write(name, content) {
    mkdirSync(dirname(this.path(name)), { recursive: true });
    writeFileSync(this.path(name), content, "latin1");
  }

  end() {
    if (this.program.exitCode !== null || this.program.signalCode !== null) return Promise.resolve();
    const ended = new Promise((done) => this.program.once("exit", done));
    this.program.kill();
    return within(PATIENCE_MS, ended, () => "gsim-studio does not end").catch((error) => {
      this.program.kill("SIGKILL");
      throw error;
    });
  }
}

export const noticed = (page, text) =>
  page.waitForFunction((words) => document.getElementById("bar").innerText.includes(words), text, { timeout: 30_000 });

/** Types at the end of the line that has this text. */
export async function typeAfter(page, text, typed) {
  await page.locator("#code .cm-line").filter({ hasText: text }).first().click();
  await page.keyboard.press("End");
  await page.keyboard.type(typed);
}

/**
 * Delays requests of a page for a file by this method, until go() is called; `count` is the number of
 * requests, and asked() waits for the first one.
 */
export async function hold(page, method, name) {
  const held = { count: 0 };
  const gate = new Promise((go) => (held.go = go));
  let begun;
  const first = new Promise((asked) => (begun = asked));
  held.asked = () => within(PATIENCE_MS, first, () => `the page makes no ${method} of ${name}`);
  await page.route(`**/file/${name}`, async (route) => {
    if (route.request().method() !== method) return route.fallback();
    ++held.count;
    begun();
    await gate;
    return route.continue();
  });
  return held;
}

/** Serves a folder of these files, opens its page, waits for its first run, and cleans up after `test`. */
export async function withServed(places, files, test, options = {}) {
  const folder = mkdtempSync(join(tmpdir(), "gsim-served-"));
  let served = null;
  try {
    served = new Served(folder, null);
    for (const [file, content] of Object.entries(files)) served.write(file, content);
    const program = join(places.build, "bin/gsim-studio");
    served.program = spawn(program, ["--no-browser", "--port", "0", folder], { stdio: ["ignore", "pipe", "inherit"] });
    const address = await addressOf(served.program);
    await withPage(address, (page) => test(page, served), options);
  } finally {
    if (served?.program) await served.end();
    rmSync(folder, { recursive: true });
  }
}

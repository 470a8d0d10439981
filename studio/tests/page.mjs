// Tests the page in Chromium, without a window, as a user would. Usage: node page.mjs BUILD [PART-OF-A-NAME]
// GSIM_RENEW_PICTURES=1 rewrites the kept pictures: check them before a commit. Times are printed, and never
// fail a test.
// LANES=2 runs two cases at once, each in its own browser, which distorts times. PART=2/3 runs each third
// case, from the second on.
// A case that is not over after four minutes has failed: it waits for an event that never comes. Ends with "N
// passed, N failed".

import { readdirSync } from "node:fs";
import { join, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { closeBrowsers, whatIsOpen } from "./browser.mjs";
import { within } from "./patience.mjs";

const here = fileURLToPath(new URL(".", import.meta.url));
const build = resolve(process.argv[2] ?? join(here, "../../build"));
const expectedValue = process.argv[3] ?? "";
export const places = {
  build,
  studio: join(build, "share/gsim/studio/studio.html"),
  gsimRun: join(build, "bin/gsim-run"),
  samples: join(here, "../../samples"),
  pictures: join(here, "pictures"),
};

const cases = [];
for (const file of readdirSync(join(here, "cases")).filter((name) => name.endsWith(".mjs")).sort()) {
  const { default: those } = await import(join(here, "cases", file));
  cases.push(...Object.entries(those).filter(([name]) => name.includes(expectedValue)));
}

const [part, parts] = (process.env.PART ?? "1/1").split("/").map(Number);
cases.splice(0, cases.length, ...cases.filter((_, index) => index % parts === part - 1));

const LONGEST_CASE_S = 240;

/** Pages of a case that is not over in time stay open. */
const inTime = (test) =>
  within(LONGEST_CASE_S * 1000, test(places), async () => `not over after ${LONGEST_CASE_S} s\n${await whatIsOpen()}`);

let [passed, failed] = [0, 0];
async function tryCase([name, test]) {
  const began = performance.now();
  try {
    await inTime(test);
    ++passed;
    console.log(`ok ${name} (${((performance.now() - began) / 1000).toFixed(1)} s)`);
  } catch (error) {
    ++failed;
    console.log(`FAILED ${name}\n  ${String(error.stack ?? error).split("\n").slice(0, 12).join("\n  ")}`);
  }
}

async function lane() {
  for (let next = cases.shift(); next; next = cases.shift()) await tryCase(next);
}
await Promise.all(Array.from({ length: Number(process.env.LANES ?? 1) }, lane));
await closeBrowsers();
console.log(`${passed} passed, ${failed} failed`);
process.exit(failed > 0 ? 1 : 0);  // even if an unfinished case still waits

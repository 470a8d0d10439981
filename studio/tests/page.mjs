// Tries the page in Chromium, without a window, as a person uses it. Usage: node page.mjs BUILD [PART-OF-A-NAME]
// GSIM_RENEW_PICTURES=1 writes the kept pictures anew: look at them before they are committed. Times are printed, and fail nothing.
// Closes with "N passed, N failed".

import { readdirSync } from "node:fs";
import { join, resolve } from "node:path";
import { fileURLToPath } from "node:url";

const here = fileURLToPath(new URL(".", import.meta.url));
const build = resolve(process.argv[2] ?? join(here, "../../build"));
const wanted = process.argv[3] ?? "";
export const places = {
  build,
  studio: join(build, "share/gsim/studio/studio.html"),
  gsimRun: join(build, "bin/gsim-run"),
  samples: join(here, "../../samples"),
  pictures: join(here, "pictures"),
};

let [passed, failed] = [0, 0];
for (const file of readdirSync(join(here, "cases")).filter((name) => name.endsWith(".mjs")).sort()) {
  const { default: cases } = await import(join(here, "cases", file));
  for (const [name, test] of Object.entries(cases)) {
    if (!name.includes(wanted)) continue;
    const began = performance.now();
    try {
      await test(places);
      ++passed;
      console.log(`ok ${name} (${((performance.now() - began) / 1000).toFixed(1)} s)`);
    } catch (fault) {
      ++failed;
      console.log(`FAILED ${name}\n  ${String(fault.stack ?? fault).split("\n").slice(0, 12).join("\n  ")}`);
    }
  }
}
console.log(`${passed} passed, ${failed} failed`);
process.exitCode = failed > 0 ? 1 : 0;

// Tries what of the page needs no page: laws and arcs, chains, blocks, words, texts, and which part knows which.
// Usage: node units.mjs [PART-OF-A-NAME]. Closes with "N passed, N failed".

import { readdirSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { loadModules } from "./frames.mjs";

const folder = fileURLToPath(new URL("./units/", import.meta.url));
const expectedValue = process.argv[2] ?? "";

/** Each file of units/ exports the modules that it tries, and cases that get them. */
const units = await Promise.all(
  readdirSync(folder)
    .filter((name) => name.endsWith(".mjs"))
    .sort()
    .map((name) => import(join(folder, name))),
);
const page = await loadModules([...new Set(units.flatMap(({ modules = [] }) => modules))]);

let [passed, failed] = [0, 0];
for (const { default: cases, modules = [] } of units) {
  const used = Object.assign({}, ...modules.map((name) => page[name]));
  for (const [name, test] of Object.entries(cases ?? {})) {
    if (!name.includes(expectedValue)) continue;
    try {
      await test(used);
      ++passed;
    } catch (error) {
      ++failed;
      console.log(`FAILED ${name}\n  ${String(error.stack ?? error).split("\n").slice(0, 8).join("\n  ")}`);
    }
  }
}
console.log(`${passed} passed, ${failed} failed`);
process.exitCode = failed > 0 ? 1 : 0;

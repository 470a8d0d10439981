// Dependencies between modules of the page: parts use core/ and run/, and never each other; core/ and run/
// use no part.

import assert from "node:assert/strict";
import { readFileSync, readdirSync } from "node:fs";
import { dirname, join, relative, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { formTexts } from "../../form_texts.mjs";

const sources = fileURLToPath(new URL("../../src/", import.meta.url));
const parts = ["bar", "code", "panels", "time", "view"];
const shared = ["core", "run", "texts"];

const files = readdirSync(sources, { recursive: true }).filter((name) => name.endsWith(".ts"));

/** Returns the module of a file, by its path below src/: its folder, or its own name. */
const moduleOf = (file) => file.split("/")[0].replace(/\.ts$/, "");

/** What a file imports, by paths below src/; packages left out. */
function* importsOf(file) {
  const text = readFileSync(join(sources, file), "utf8");
  for (const [, from] of text.matchAll(/(?:from|import)\s*\(?\s*"(\.[^"]*)"/g)) {
    yield relative(sources, resolve(dirname(join(sources, file)), from));
  }
}

const mayKnow = (module) => {
  if (shared.includes(module)) return module === "texts" ? ["texts"] : shared;
  if (parts.includes(module)) return [module, ...shared];
  return [...parts, ...shared, "embedded", "page", "served", "style.css"];
};

const offences = files.flatMap((file) =>
  [...importsOf(file)].filter((used) => !mayKnow(moduleOf(file)).includes(moduleOf(used))).map((used) => `${file} imports ${used}`),
);

/** The file below src/ that an import means. */
const fileOf = (used) => [`${used}.ts`, `${used}/index.ts`, used].find((each) => files.includes(each));

/** Files that import each other, directly or not, as lists in the order of their imports. */
function circlesOf(importing) {
  const done = new Set();
  const circles = [];
  const visit = (file, path) => {
    if (path.includes(file)) circles.push([...path.slice(path.indexOf(file)), file]);
    if (path.includes(file) || done.has(file)) return;
    for (const used of importing(file)) visit(used, [...path, file]);
    done.add(file);
  };
  for (const file of files) visit(file, []);
  return circles;
}

/** All that a file brings along, itself among it. */
function reached(first) {
  const found = new Set([first]);
  for (const file of found) {
    for (const used of importsOf(file)) {
      const name = fileOf(used);
      if (name) found.add(name);
    }
  }
  return [...found];
}

export default {
  "all parts are looked at": () => {
    for (const module of [...parts, ...shared]) assert.ok(files.some((file) => moduleOf(file) === module), module);
    const [first] = importsOf("core/display_state.ts");
    assert.equal(first, "run/report");
  },

  "no part knows another one, and what they share knows none": () => assert.deepEqual(offences, []),

  "no files import each other in a circle": () => {
    const [first, second] = files;
    assert.deepEqual(circlesOf((file) => (file === first ? [second] : file === second ? [first] : [])), [[first, second, first]]);
    assert.deepEqual(circlesOf((file) => [...importsOf(file)].map(fileOf).filter((used) => used !== undefined)), []);
  },

  "a page without forms says nothing that it does not have": () => {
    const all = reached("viewer.ts").filter((file) => moduleOf(file) !== "texts");
    assert.ok(all.includes("view/view.ts") && !all.includes("panels/variants/index.ts"));
    const said = new RegExp(`\\btexts\\.(${formTexts.join("|")})\\b`);
    assert.deepEqual(all.filter((file) => said.test(readFileSync(join(sources, file), "utf8"))), []);
  },

  "elements are made by core/dom.ts alone": () => {
    // A canvas that is never shown.
    const own = ["core/dom.ts", "view/canvas.ts"];
    const makers = files.filter((file) => /createElement(NS)?\(/.test(readFileSync(join(sources, file), "utf8")));
    assert.deepEqual(makers.filter((file) => !own.includes(file)), []);
  },

  "no file has more than 400 lines": () => {
    assert.deepEqual(files.filter((file) => readFileSync(join(sources, file), "utf8").split("\n").length > 401), []);
  },

  "each text is used": () => {
    const isText = (file) => moduleOf(file) === "texts";
    const joined = (some) => some.map((file) => readFileSync(join(sources, file), "utf8")).join("\n");
    const all = joined(files.filter((file) => !isText(file)));
    const words = joined(files.filter(isText)).matchAll(/^(?: {2}| {4})(\w+):/gm);
    assert.deepEqual([...words].map(([, key]) => key).filter((key) => !new RegExp(`\\b${key}\\b`).test(all)), []);
  },
};

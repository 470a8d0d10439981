// Makes the page: one file with everything in it. Usage: node build.mjs ENGINE_FOLDER SAMPLES_FOLDER OUTPUT_FOLDER
// The engine's folder holds gsim-studio-engine.js and .wasm (preset wasm). Written are studio.html, with the engine and
// the samples, view.html, into which gsim-run --view puts a run, and served.html, which gsim-studio serves beside its own engine.

import { gzipSync } from "node:zlib";
import { mkdirSync, readdirSync, readFileSync, statSync, writeFileSync } from "node:fs";
import { join, relative, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import * as esbuild from "esbuild";
import { formTexts } from "./form_texts.mjs";

const here = fileURLToPath(new URL(".", import.meta.url));
const [engineFolder, samplesFolder, distFolder] = process.argv.slice(2).map((name) => resolve(name));

const packed = (bytes) => gzipSync(bytes, { level: 9 }).toString("base64");

/** In a script element nothing may look like its end. */
const inline = (code) => code.replaceAll("</script", "<\\/script");

async function bundle(entry, options = {}) {
  const built = await esbuild.build({
    entryPoints: [join(here, "src", entry)],
    bundle: true,
    minify: true,
    format: "iife",
    target: ["chrome97", "firefox113", "safari16.4"],
    charset: "utf8",
    write: false,
    outdir: "out",
    logLevel: "warning",
    legalComments: "none", // licences() has them whole
    metafile: true,
    ...options,
  });
  const text = (extension) => built.outputFiles.find((file) => file.path.endsWith(extension))?.text ?? "";
  return { js: text(".js"), css: text(".css"), inputs: Object.keys(built.metafile.inputs) };
}

/** A page without forms does not have what they say. */
const omitFormTexts = {
  name: "without-forms",
  setup: (build) =>
    build.onLoad({ filter: new RegExp(`/src/texts/(${formTexts.join("|")})\\.ts$`) }, ({ path }) => ({
      contents: `export const ${path.match(/(\w+)\.ts$/)[1]} = {};`,
    })),
};

/** Of the packages that are bundled, and of the libraries in the engine (Debian's, by name): the terms go with the page. */
function licences(inputs, libraries) {
  const bundled = inputs.flatMap((file) => file.match(/node_modules\/((?:@[^/]+\/)?[^/]+)\//)?.[1] ?? []);
  const texts = [...new Set(bundled)].sort().map((name) => {
    const folder = join(here, "node_modules", name);
    const file = readdirSync(folder).find((each) => /^licen[sc]e/i.test(each));
    if (!file) throw new Error(`${name} has no licence`);
    return `${name}\n\n${readFileSync(join(folder, file), "utf8")}`;
  });
  for (const name of libraries) texts.push(`${name}\n\n${readFileSync(`/usr/share/doc/${name}/copyright`, "utf8")}`);
  const own = readFileSync(join(here, "../LICENSE"), "utf8");
  return `<script type="text/plain" id="licences">${inline([`gsim\n\n${own}`, ...texts].join("\n\n"))}</script>`;
}

/** What is compiled into the engine. */
const libraries = ["libeigen3-dev", "libexpected-dev", "libfast-float-dev", "libfmt-dev", "liblua5.4-dev", "libpugixml-dev"].concat([
  "libtomlplusplus-dev",
  "nlohmann-json3-dev",
]);

function* listFilesRecursively(folder) {
  for (const name of readdirSync(folder).sort()) {
    const file = join(folder, name);
    if (statSync(file).isDirectory()) yield* listFilesRecursively(file);
    else yield file;
  }
}

/** Samples by the names that the page gives them; what is no text is told apart by its bytes. */
function samples() {
  const texts = {};
  const others = {};
  for (const file of listFilesRecursively(samplesFolder)) {
    const name = `samples/${relative(samplesFolder, file)}`;
    if (name.startsWith("samples/engine/")) continue;
    const bytes = readFileSync(file);
    if (bytes.includes(0)) others[name] = bytes.toString("base64");
    else texts[name] = bytes.toString("utf8");
  }
  return JSON.stringify({ texts, others });
}

const data = (id, text) => `<script type="application/octet-stream" id="${id}">${text}</script>`;

const engine = join(engineFolder, "gsim-studio-engine");
const [page, viewer, worker] = await Promise.all([
  bundle("main.ts"),
  bundle("viewer.ts", { plugins: [omitFormTexts] }),
  bundle("worker.ts", { alias: { "gsim-engine": `${engine}.js` } }),
]);
const fill = (parts) =>
  readFileSync(join(here, "src/page.html"), "utf8").replace(/<!-- ([a-z]+) -->/g, (_, name) => parts[name] ?? "");

const inlineParts = ({ css, js }) => ({ style: `<style>${css}</style>`, script: `<script>${inline(js)}</script>` });
mkdirSync(distFolder, { recursive: true });
const standalonePage = fill({
  ...inlineParts(page),
  data: [
    data("worker", packed(worker.js)),
    data("engine", packed(readFileSync(`${engine}.wasm`))),
    data("samples", packed(samples())),
    licences(page.inputs, libraries),
  ].join("\n"),
});
const viewerPage = fill({ ...inlineParts(viewer), data: `<!-- run -->\n${licences(viewer.inputs, [])}` });
const served = fill({
  ...inlineParts(page),
  policy: "; connect-src 'self'",
  data: [
    `<script type="application/json" id="server"><!-- server --></script>`,
    data("samples", packed(samples())),
    licences(page.inputs, []),
  ].join("\n"),
});
for (const [name, text] of Object.entries({ "studio.html": standalonePage, "view.html": viewerPage, "served.html": served })) {
  writeFileSync(join(distFolder, name), text);
  console.log(`${name}: ${text.length} bytes, ${gzipSync(text, { level: 9 }).length} with gzip`);
}

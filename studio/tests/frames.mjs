// Code of the page, for node: runs as in the page, from pages that gsim-run --view has written.

import { gunzipSync } from "node:zlib";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";
import * as esbuild from "esbuild";

const sources = fileURLToPath(new URL("../src/", import.meta.url));

/** Returns the exports of a module of the page with these contents. */
async function bundled(contents) {
  const folder = mkdtempSync(join(tmpdir(), "gsim-studio-"));
  try {
    const outfile = join(folder, "page.mjs");
    await esbuild.build({
      stdin: { contents, resolveDir: sources, loader: "ts" },
      bundle: true,
      format: "esm",
      platform: "node",
      outfile,
    });
    return await import(pathToFileURL(outfile));
  } finally {
    rmSync(folder, { recursive: true });
  }
}

const exported = (file, i) => `import * as module${i} from ${JSON.stringify(file)}; export { module${i} };`;

/** Modules of the page by their paths below src/, or of packages by their names; all of them share what they import. */
export async function loadModules(files) {
  const all = await bundled(files.map((file, i) => exported(file.startsWith("@") || file === "three" ? file : `./${file}`, i)).join("\n"));
  return Object.fromEntries(files.map((file, i) => [file, all[`module${i}`]]));
}

/** What readRun works with. */
export const loadPage = () =>
  bundled(["core/message", "run/run", "run/chain", "run/limits", "run/kinds"].map((file) => `export * from "./${file}";`).join("\n"));

/** The frames of a finished run in a page's text. */
export function packedRun(html) {
  const found = html.match(/id="run">([A-Za-z0-9+/=]*)<\/script>/);
  if (!found) throw new Error("there is no run in the page");
  return new Uint8Array(gunzipSync(Buffer.from(found[1], "base64")));
}

export function readRun(page, html) {
  const run = new page.Run();
  for (const frame of page.splitFrames(packedRun(html))) {
    const message = page.readMessage(frame.slice());
    if (message.is !== "source") run.addMessage(message);
  }
  return run;
}

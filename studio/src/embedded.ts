// Contents of the page's own file: the engine, the samples, or a finished run; each packed with gzip, as
// base64.

import type { FileContent } from "./core/file_content";

function decodeBase64(base64: string): Uint8Array<ArrayBuffer> {
  const text = atob(base64);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  return bytes;
}

async function unpack(id: string): Promise<ArrayBuffer | null> {
  const element = document.getElementById(id);
  if (!element) return null;
  const packed = decodeBase64(element.textContent ?? "");
  element.remove(); // it is not needed twice, and may be large
  return new Response(new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"))).arrayBuffer();
}

/** Data that gsim-studio passes to the page that it serves. */
export interface ServedFolder {
  /** Name of the folder. */
  name: string;
  /** Requested file names: keys of Setup, empty if nothing was requested. */
  setup: Record<string, string>;
}

export const embedded = {
  has: (id: "engine" | "run"): boolean => document.getElementById(id) !== null,

  async module(): Promise<WebAssembly.Module> {
    return WebAssembly.compile((await unpack("engine"))!);
  },

  async workerUrl(): Promise<string> {
    return URL.createObjectURL(new Blob([(await unpack("worker"))!], { type: "text/javascript" }));
  },

  async samples(): Promise<Map<string, FileContent>> {
    const bytes = await unpack("samples");
    if (!bytes) return new Map();
    const { texts, others } = JSON.parse(new TextDecoder().decode(bytes)) as Record<string, Record<string, string>>;
    const files = new Map<string, FileContent>(Object.entries(texts));
    for (const [name, base64] of Object.entries(others)) files.set(name, decodeBase64(base64));
    return files;
  },

  /** Returns null if the page is not served, for example because it was opened from a disk. */
  served(): ServedFolder | null {
    const text = document.getElementById("server")?.textContent ?? "";
    if (!text.startsWith("{")) return null;
    const { folder, setup } = JSON.parse(text) as { folder: string; setup: Record<string, string> };
    return { name: folder, setup };
  },

  /** Returns the frames of a finished run, one after another. */
  async run(): Promise<Uint8Array> {
    return new Uint8Array((await unpack("run"))!);
  },
};

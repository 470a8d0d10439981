// Engine side of the page: runs in a worker, so that the page stays responsive and can end the engine.

// @ts-expect-error: written by emscripten (make studio)
import createEngine from "gsim-engine";
import type { EngineRequest, FromWorker, ToWorker } from "./core/worker_protocol";

interface Engine {
  ccall(name: string, result: null, types: string[], values: string[]): void;
}

declare const self: DedicatedWorkerGlobalScope;

let engine: Promise<Engine> | null = null;
let currentRequest = 0;
let files = new Map<string, string | Uint8Array>();
const encoder = new TextEncoder();

function start(module: WebAssembly.Module): Promise<Engine> {
  return createEngine({
    instantiateWasm(imports: WebAssembly.Imports, use: (instance: WebAssembly.Instance) => void) {
      void WebAssembly.instantiate(module, imports).then(use);
      return {};
    },
    readFile(name: string): Uint8Array | null {
      const file = files.get(name);
      if (file === undefined) return null;
      return typeof file === "string" ? encoder.encode(file) : file;
    },
    post(bytes: Uint8Array<ArrayBuffer>) {
      const message: FromWorker = { id: currentRequest, bytes };
      self.postMessage(message, [bytes.buffer]);
    },
    print() {},
    printErr() {},
  });
}

async function handleRequest(ask: EngineRequest): Promise<void> {
  const ready = await engine!;
  currentRequest = ask.id;
  files = ask.files;
  ready.ccall("gsim_studio_serve", null, ["string"], [JSON.stringify(ask.request)]);
}

/** Reports a fatal error of the engine as an error of the worker: the page starts another one. */
function fail(error: unknown): void {
  setTimeout(() => {
    throw error;
  });
}

self.onmessage = (event: MessageEvent<ToWorker>) => {
  if (event.data.kind === "start") engine = start(event.data.module);
  else void handleRequest(event.data).catch(fail);
};

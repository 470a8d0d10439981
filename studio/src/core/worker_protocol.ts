// Messages between page and worker. Each request has a number, which all parts of its response carry.

/** First message: the engine, compiled once and shared by all workers. */
export interface StartMessage {
  kind: "start";
  module: WebAssembly.Module;
}

/** Request (docs/studio.md), and the files that it may name. */
export interface EngineRequest {
  kind: "ask";
  id: number;
  request: Record<string, unknown>;
  files: Map<string, string | Uint8Array>;
}

export type ToWorker = StartMessage | EngineRequest;

/** Frame of the engine; the frames of a request end with "done" or "failed". */
export interface FromWorker {
  id: number;
  bytes: Uint8Array<ArrayBuffer>;
}

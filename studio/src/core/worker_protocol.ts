// What page and worker say to each other. Each question has a number; all that belongs to its answer carries it.

/** First of all: the engine, compiled once and shared by all workers. */
export interface Start {
  kind: "start";
  module: WebAssembly.Module;
}

/** A request (docs/studio.md), and the files that it may name. */
export interface Ask {
  kind: "ask";
  id: number;
  request: Record<string, unknown>;
  files: Map<string, string | Uint8Array>;
}

export type ToWorker = Start | Ask;

/** A frame of the engine's; those of a question end with "done" or "failed". */
export interface FromWorker {
  id: number;
  bytes: Uint8Array<ArrayBuffer>;
}

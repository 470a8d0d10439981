// Engine that is part of the page. It runs in a worker, next to the page, and can be ended.

import { readResult, cancelled, type RequestResult, type Engine, type Files } from "./engine";
import { readMessage, type Message } from "./message";
import type { EngineRequest, FromWorker, ToWorker } from "./worker_protocol";

/**
 * Limit in bytes of files. Memory of an engine grows and never shrinks, so an engine that had more is ended
 * after its response.
 */
const LARGE_FILES = 4_000_000;

const totalSize = (files: Files): number => [...files.values()].reduce((sum, { length }) => sum + length, 0);

interface PendingRequest {
  onMessage: (message: Message) => void;
  end: (response: RequestResult) => void;
}

export class WorkerEngine implements Engine {
  readonly available = true;
  readonly runStorage = null;
  private worker: Worker | null = null;
  private readonly open = new Map<number, PendingRequest>();
  private next = 1;
  private grown = false;

  constructor(
    private readonly makeWorker: () => Worker,
    private readonly module: Promise<WebAssembly.Module>,
  ) {}

  async ask(request: Record<string, unknown>, files: Files, onMessage: (message: Message) => void): Promise<RequestResult> {
    const id = this.next++;
    return new Promise((end) => {
      this.open.set(id, { onMessage, end });
      void this.module.then((module) => {
        // cancel() may have been called first.
        if (this.open.has(id)) this.send(module, { kind: "ask", id, request, files });
      });
    });
  }

  /** Ends the worker; the next request starts a new one. */
  cancel(): void {
    this.endAll(cancelled);
  }

  private send(module: WebAssembly.Module, ask: EngineRequest): void {
    if (!this.worker) this.worker = this.startWorker(module);
    if (totalSize(ask.files) > LARGE_FILES) this.grown = true;
    this.worker.postMessage(ask satisfies ToWorker);
  }

  private startWorker(module: WebAssembly.Module): Worker {
    this.grown = false;
    const worker = this.makeWorker();
    worker.postMessage({ kind: "start", module } satisfies ToWorker);
    worker.onmessage = (event: MessageEvent<FromWorker>) => this.receive(event.data);
    worker.onerror = (event) => this.fail(event.message || "the engine ended");
    return worker;
  }

  private receive({ id, bytes }: FromWorker): void {
    const pendingRequest = this.open.get(id);
    if (!pendingRequest) return;
    let message: Message;
    try {
      message = readMessage(bytes);
    } catch (error) {
      return this.fail(String(error));
    }
    pendingRequest.onMessage(message);
    const response = readResult(message);
    if (!response) return;
    this.open.delete(id);
    if (this.grown && this.open.size === 0) this.endWorker();
    pendingRequest.end(response);
  }

  // Out of memory, or an internal error of the engine: a new worker starts from an empty state.
  private fail(why: string): void {
    this.endAll({ ok: false, code: "internal", message: why });
  }

  private endAll(response: RequestResult): void {
    this.endWorker();
    for (const pendingRequest of this.open.values()) pendingRequest.end(response);
    this.open.clear();
  }

  private endWorker(): void {
    this.worker?.terminate();
    this.worker = null;
  }
}

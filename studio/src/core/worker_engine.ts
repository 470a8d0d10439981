// Engine that is part of the page. It runs in a worker, next to the page, and can be ended.

import { answerOf, cancelled, type Answer, type Engine, type Files } from "./engine";
import { readMessage, type Message } from "./message";
import type { Ask, FromWorker, ToWorker } from "./worker_protocol";

/**
 * Limit in bytes of files. Memory of an engine grows and never shrinks, so an engine that had more is ended
 * after its response.
 */
const LARGE_FILES = 4_000_000;

const sizeOf = (files: Files): number => [...files.values()].reduce((sum, { length }) => sum + length, 0);

interface Question {
  take: (message: Message) => void;
  end: (answer: Answer) => void;
}

export class WorkerEngine implements Engine {
  readonly available = true;
  readonly keeper = null;
  private worker: Worker | null = null;
  private readonly open = new Map<number, Question>();
  private next = 1;
  private grown = false;

  constructor(
    private readonly makeWorker: () => Worker,
    private readonly module: Promise<WebAssembly.Module>,
  ) {}

  async ask(request: Record<string, unknown>, files: Files, take: (message: Message) => void): Promise<Answer> {
    const id = this.next++;
    return new Promise((end) => {
      this.open.set(id, { take, end });
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

  private send(module: WebAssembly.Module, ask: Ask): void {
    if (!this.worker) this.worker = this.startWorker(module);
    if (sizeOf(ask.files) > LARGE_FILES) this.grown = true;
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
    const question = this.open.get(id);
    if (!question) return;
    let message: Message;
    try {
      message = readMessage(bytes);
    } catch (fault) {
      return this.fail(String(fault));
    }
    question.take(message);
    const answer = answerOf(message);
    if (!answer) return;
    this.open.delete(id);
    if (this.grown && this.open.size === 0) this.endWorker();
    question.end(answer);
  }

  // Out of memory, or an internal error of the engine: a new worker starts from an empty state.
  private fail(why: string): void {
    this.endAll({ ok: false, code: "internal", message: why });
  }

  private endAll(answer: Answer): void {
    this.endWorker();
    for (const question of this.open.values()) question.end(answer);
    this.open.clear();
  }

  private endWorker(): void {
    this.worker?.terminate();
    this.worker = null;
  }
}

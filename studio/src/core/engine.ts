// The engine as the rest of the page sees it: a question, what it tells meanwhile, and how it ended.

import { readMessage, type Message } from "./message";
import type { Ask, FromWorker, ToWorker } from "./worker_protocol";

export type Files = Map<string, string | Uint8Array>;

/** How a question ended. */
export interface Answer {
  ok: boolean;
  /** Of a failure; "cancelled" where cancel() ended it. */
  code: string;
  message: string;
}

/** Memory of an engine grows and never shrinks: one that had more bytes of files than this is ended behind its answer. */
const LARGE_FILES = 4_000_000;

const sizeOf = (files: Files): number => [...files.values()].reduce((sum, { length }) => sum + length, 0);

interface Question {
  id: number;
  take: (message: Message) => void;
  end: (answer: Answer) => void;
}

/**
 * One engine in a worker of its own; one question at a time, the others wait. Where a page has no engine (a run
 * to look at), `available` is false and every question fails.
 */
export class Engine {
  private worker: Worker | null = null;
  private readonly open = new Map<number, Question>();
  private next = 1;
  private grown = false;

  constructor(
    private readonly makeWorker: (() => Worker) | null,
    private readonly module: Promise<WebAssembly.Module> | null,
  ) {}

  get available(): boolean {
    return this.makeWorker !== null;
  }

  /** Asks; `take` gets what the engine tells as it is told. */
  async ask(request: Record<string, unknown>, files: Files, take: (message: Message) => void): Promise<Answer> {
    if (!this.makeWorker || !this.module) {
      return { ok: false, code: "unavailable", message: "this page has no engine" };
    }
    const id = this.next++;
    return new Promise((end) => {
      this.open.set(id, { id, take, end });
      void this.module!.then((module) => {
        // cancel() may have come first.
        if (this.open.has(id)) this.send(module, { kind: "ask", id, request, files });
      });
    });
  }

  /** Ends all questions at once: the worker is ended, and the next question gets a new one. */
  cancel(): void {
    this.worker?.terminate();
    this.worker = null;
    for (const question of this.open.values()) {
      question.end({ ok: false, code: "cancelled", message: "cancelled" });
    }
    this.open.clear();
  }

  private send(module: WebAssembly.Module, ask: Ask): void {
    if (!this.worker) this.worker = this.startWorker(module);
    if (sizeOf(ask.files) > LARGE_FILES) this.grown = true;
    this.worker.postMessage(ask satisfies ToWorker);
  }

  private startWorker(module: WebAssembly.Module): Worker {
    this.grown = false;
    const worker = this.makeWorker!();
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
    if (message.is !== "done" && message.is !== "failed") return;
    this.open.delete(id);
    if (this.grown && this.open.size === 0) {
      this.worker?.terminate();
      this.worker = null;
    }
    const header = message.header as { code?: string; message?: string };
    question.end({ ok: message.is === "done", code: header.code ?? "", message: header.message ?? "" });
  }

  // Out of memory, or a fault of the engine's: a new worker begins from nothing.
  private fail(why: string): void {
    this.worker?.terminate();
    this.worker = null;
    for (const question of this.open.values()) question.end({ ok: false, code: "internal", message: why });
    this.open.clear();
  }
}

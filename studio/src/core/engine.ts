// The engine as the rest of the page sees it: a question, what it tells meanwhile, and how it ended.

import type { Message } from "./message";

export type Files = Map<string, string | Uint8Array>;

/** How a question ended. */
export interface Answer {
  ok: boolean;
  /** Of a failure; "cancelled" where cancel() ended it. */
  code: string;
  message: string;
}

export const cancelled: Answer = { ok: false, code: "cancelled", message: "cancelled" };

/** Keeps runs that are too long for a page. */
export interface Keeper {
  /** Most blocks of a run that it keeps. */
  readonly blocks: number;
  /** The whole message of segments of this number, of a run that is kept under this name. Throws with a sentence. */
  laws(run: string, number: number): Promise<Message>;
}

/** Answers one question at a time, the others wait. */
export interface Engine {
  /** Where a page has no engine (a run to look at) every question fails. */
  readonly available: boolean;
  /** null: what a run tells it tells once, and whole. */
  readonly keeper: Keeper | null;
  /** Asks; `take` gets what the engine tells as it is told. `keptAs`: the name that a keeper keeps the run under; empty: not. */
  ask(request: Record<string, unknown>, files: Files, take: (message: Message) => void, keptAs?: string): Promise<Answer>;
  /** Ends all questions at once. */
  cancel(): void;
}

export const noEngine: Engine = {
  available: false,
  keeper: null,
  ask: () => Promise.resolve({ ok: false, code: "unavailable", message: "this page has no engine" }),
  cancel() {},
};

/** How a question ended by its last message; null: it is not the last. */
export function answerOf({ is, header }: Message): Answer | null {
  if (is !== "done" && is !== "failed") return null;
  const { code = "", message = "" } = header as { code?: string; message?: string };
  return { ok: is === "done", code, message };
}

// Engine as seen by the page: a request, messages during its processing, and its result.

import type { Message } from "./message";

export type Files = Map<string, string | Uint8Array>;

/** How a question ended. */
export interface RequestResult {
  ok: boolean;
  /** Code of an error; "cancelled" if cancel() ended it. */
  code: string;
  message: string;
}

export const cancelled: RequestResult = { ok: false, code: "cancelled", message: "cancelled" };

/** Storage of runs that are too long for a page. */
export interface RunStorage {
  /** Max number of blocks of a run that it keeps. */
  readonly blocks: number;
  /**
   * Returns the complete segment message of this number, for a run kept under this name. Throws with a
   * message.
   */
  laws(run: string, number: number): Promise<Message>;
}

/** Engine that processes one request at a time; the others wait. */
export interface Engine {
  /** False if a page has no engine (a run to view): every request fails. */
  readonly available: boolean;
  /** null: a run sends its messages once, and complete. */
  readonly runStorage: RunStorage | null;
  /**
   * Sends a request; `onMessage` receives the engine's messages as they come. `storageKey`: the name under
   * which `runStorage` stores the run; empty: not stored.
   */
  ask(request: Record<string, unknown>, files: Files, onMessage: (message: Message) => void, storageKey?: string): Promise<RequestResult>;
  /** Ends all questions at once. */
  cancel(): void;
}

export const noEngine: Engine = {
  available: false,
  runStorage: null,
  ask: () => Promise.resolve({ ok: false, code: "unavailable", message: "this page has no engine" }),
  cancel() {},
};

/** Returns the result of a request from its last message; null: it is not the last. */
export function readResult({ is, header }: Message): RequestResult | null {
  if (is !== "done" && is !== "failed") return null;
  const { code = "", message = "" } = header as { code?: string; message?: string };
  return { ok: is === "done", code, message };
}

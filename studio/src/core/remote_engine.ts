// Engine of a page that gsim-studio serves: it runs in parallel to the browser, and reads the folder by
// itself.

import { texts } from "../texts";
import { readResult, cancelled, type RequestResult, type Engine, type Files, type RunStorage } from "./engine";
import { FrameSplitter } from "./frame_splitter";
import { readMessage, type Message } from "./message";
import { errorMessage, type Server } from "./server";

type MessageHandler = (message: Message) => void;

const words = texts.folder;

/** Segments of a run that a page gets complete; later ones are reduced to the TCP path. */
const MAX_FULL_SEGMENTS = 1_000_000;
/** Each block takes 20 bytes of the page's memory and 20 of the graphics card's. */
const MAX_STORED_BLOCKS = 20_000_000;
/** Status if the server has no space to keep a run. */
const INSUFFICIENT_STORAGE = 507;

const failed = (message: string, code = "server"): RequestResult => ({ ok: false, code, message });

/** Number of bytes that one call takes as its arguments. */
const CHUNK_BYTES = 0x8000;

function toBase64(bytes: Uint8Array): string {
  let text = "";
  for (let at = 0; at < bytes.length; at += CHUNK_BYTES) text += String.fromCharCode(...bytes.subarray(at, at + CHUNK_BYTES));
  return btoa(text);
}

/** Replaces unpaired surrogates, which have no bytes in UTF-8. */
const wellFormed = (text: string): string => text.replace(/\p{Surrogate}/gu, "\ufffd");

function requestBody(request: Record<string, unknown>, all: Files): string {
  const files: Record<string, string> = {};
  const binary: Record<string, string> = {};
  for (const [name, content] of all) {
    if (typeof content === "string") files[name] = wellFormed(content);
    else binary[name] = toBase64(content);
  }
  return JSON.stringify({ request, files, binary });
}

/** Reads messages until the one that ends the response. */
async function receive(reader: ReadableStreamDefaultReader<Uint8Array>, signal: AbortSignal, onMessage: MessageHandler): Promise<RequestResult> {
  const cutter = new FrameSplitter();
  let result: RequestResult | null = null;
  const onFrame = (frame: Uint8Array) => {
    const message = readMessage(frame);
    onMessage(message);
    result ??= readResult(message);
  };
  try {
    while (!result) {
      const { value, done } = await reader.read();
      if (signal.aborted) return cancelled;
      if (done) return failed(words.incompleteResponse);
      cutter.push(value, onFrame);
    }
    return result;
  } catch (error) {
    void reader.cancel().catch(() => {}); // the remainder of a broken response is not needed
    throw error;
  }
}

export class RemoteEngine implements Engine {
  readonly available = true;
  readonly runStorage: RunStorage;
  private abortController = new AbortController();
  private last: Promise<unknown> = Promise.resolve();

  constructor(
    private readonly server: Server,
    private readonly wholeSegments = MAX_FULL_SEGMENTS,
  ) {
    this.runStorage = { blocks: MAX_STORED_BLOCKS, laws: (run, number) => server.laws(run, number) };
  }

  ask(request: Record<string, unknown>, files: Files, onMessage: MessageHandler, storageKey = ""): Promise<RequestResult> {
    const { signal } = this.abortController;
    const result = this.last.then(() => this.postRequest(requestBody(request, files), signal, onMessage, storageKey));
    this.last = result;
    return result;
  }

  /** Cancels the requests: the server ends a request with a closed connection. */
  cancel(): void {
    this.abortController.abort();
    this.abortController = new AbortController();
    this.last = Promise.resolve();
  }

  private async postRequest(body: string, signal: AbortSignal, onMessage: MessageHandler, storageKey: string): Promise<RequestResult> {
    if (signal.aborted) return cancelled;
    const kept: Record<string, string> = storageKey ? { Run: storageKey, Whole: String(this.wholeSegments) } : {};
    try {
      const response = await fetch(this.server.address("ask"), {
        method: "POST",
        headers: { "Content-Type": "application/json", ...kept },
        body,
        signal,
      });
      if (response.status === INSUFFICIENT_STORAGE) return failed(await errorMessage(response), "no-room");
      if (!response.ok || !response.body) return failed(await errorMessage(response));
      return await receive(response.body.getReader(), signal, onMessage);
    } catch (error) {
      if (signal.aborted) return cancelled;
      return failed(error instanceof TypeError ? words.noAnswer : String(error));
    }
  }
}


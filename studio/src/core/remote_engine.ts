// Engine of a page that gsim-studio serves: it runs in parallel to the browser, and reads the folder by
// itself.

import { texts } from "../texts";
import { answerOf, cancelled, type Answer, type Engine, type Files, type Keeper } from "./engine";
import { FrameCutter } from "./frame_cutter";
import { readMessage, type Message } from "./message";
import { sentenceOf, type Server } from "./server";

type Take = (message: Message) => void;

const words = texts.folder;

/** Segments of a run that a page gets complete; later ones are reduced to the TCP path. */
const WHOLE_SEGMENTS = 1_000_000;
/** Each block takes 20 bytes of the page's memory and 20 of the graphics card's. */
const MOST_KEPT_BLOCKS = 20_000_000;
/** Status if the server has no space to keep a run. */
const NO_ROOM = 507;

const failed = (message: string, code = "server"): Answer => ({ ok: false, code, message });

/** Number of bytes that one call takes as its arguments. */
const PIECE = 0x8000;

function base64Of(bytes: Uint8Array): string {
  let text = "";
  for (let at = 0; at < bytes.length; at += PIECE) text += String.fromCharCode(...bytes.subarray(at, at + PIECE));
  return btoa(text);
}

/** Replaces unpaired surrogates, which have no bytes in UTF-8. */
const wellFormed = (text: string): string => text.replace(/\p{Surrogate}/gu, "\ufffd");

function bodyOf(request: Record<string, unknown>, all: Files): string {
  const files: Record<string, string> = {};
  const binary: Record<string, string> = {};
  for (const [name, content] of all) {
    if (typeof content === "string") files[name] = wellFormed(content);
    else binary[name] = base64Of(content);
  }
  return JSON.stringify({ request, files, binary });
}

/** Reads messages until the one that ends the response. */
async function receive(reader: ReadableStreamDefaultReader<Uint8Array>, signal: AbortSignal, take: Take): Promise<Answer> {
  const cutter = new FrameCutter();
  let answer: Answer | null = null;
  const takeFrame = (frame: Uint8Array) => {
    const message = readMessage(frame);
    take(message);
    answer ??= answerOf(message);
  };
  try {
    while (!answer) {
      const { value, done } = await reader.read();
      if (signal.aborted) return cancelled;
      if (done) return failed(words.cutOff);
      cutter.push(value, takeFrame);
    }
    return answer;
  } catch (fault) {
    void reader.cancel().catch(() => {}); // the remainder of a broken response is not needed
    throw fault;
  }
}

export class RemoteEngine implements Engine {
  readonly available = true;
  readonly keeper: Keeper;
  private aborting = new AbortController();
  private last: Promise<unknown> = Promise.resolve();

  constructor(
    private readonly server: Server,
    private readonly wholeSegments = WHOLE_SEGMENTS,
  ) {
    this.keeper = { blocks: MOST_KEPT_BLOCKS, laws: (run, number) => server.laws(run, number) };
  }

  ask(request: Record<string, unknown>, files: Files, take: Take, keptAs = ""): Promise<Answer> {
    const { signal } = this.aborting;
    const answer = this.last.then(() => this.askNow(bodyOf(request, files), signal, take, keptAs));
    this.last = answer;
    return answer;
  }

  /** Cancels the requests: the server ends a request with a closed connection. */
  cancel(): void {
    this.aborting.abort();
    this.aborting = new AbortController();
    this.last = Promise.resolve();
  }

  private async askNow(body: string, signal: AbortSignal, take: Take, keptAs: string): Promise<Answer> {
    if (signal.aborted) return cancelled;
    const kept: Record<string, string> = keptAs ? { Run: keptAs, Whole: String(this.wholeSegments) } : {};
    try {
      const response = await fetch(this.server.address("ask"), {
        method: "POST",
        headers: { "Content-Type": "application/json", ...kept },
        body,
        signal,
      });
      if (response.status === NO_ROOM) return failed(await sentenceOf(response), "no-room");
      if (!response.ok || !response.body) return failed(await sentenceOf(response));
      return await receive(response.body.getReader(), signal, take);
    } catch (fault) {
      if (signal.aborted) return cancelled;
      return failed(fault instanceof TypeError ? words.noAnswer : String(fault));
    }
  }
}


// Requests to gsim-studio about the folder that it serves (docs/studio.md). Addresses are relative to the
// address of the page.

import { texts } from "../texts";
import { readMessage, type Message } from "./message";

export interface FolderFile {
  name: string;
  bytes: number;
  /** Tag of this version of the file; another version has another tag. */
  tag: string;
}

export interface Listing {
  files: FolderFile[];
  /** Whether there are more. */
  cut: boolean;
}

/** Change of a file; the tag is null if the file was deleted. */
export interface FolderChange {
  name: string;
  tag: string | null;
}

/**
 * Result of writing a file. Not ok: the version on the disk (null: none) differs from the one that was to be
 * replaced.
 */
export type WriteResult = { ok: true; tag: string } | { ok: false; tag: string | null };

/** Error with the message of the server. */
export class RejectedRequest extends Error {}

/** Changes since an earlier response. `again`: changes may have been missed, so list all files again. */
interface Changes {
  at: number;
  again: boolean;
  changed: FolderChange[];
}

const POLL_MS = 500;
/** Time without a response after which the server counts as gone. */
const RESPONSE_TIMEOUT_MS = 20_000;

const pause = (ms: number) => new Promise((go) => setTimeout(go, ms));

/** Returns why the server refused, in its own words if it sent some. */
export async function errorMessage(response: Response): Promise<string> {
  const { error } = await responseJson(response);
  return typeof error === "string" ? error : texts.folder.refused(response.status);
}

const responseJson = async (response: Response): Promise<Record<string, unknown>> =>
  ((await response.json().catch(() => null)) ?? {}) as Record<string, unknown>;

const responseTag = (response: Response): string => (response.headers.get("ETag") ?? "").replace(/^(?:W\/)?"(.*)"$/, "$1");

const encodePath = (name: string): string => name.split("/").map(encodeURIComponent).join("/");

export class Server {
  constructor(private readonly page: URL) {}

  address(path: string): URL {
    return new URL(path, this.page);
  }

  async list(): Promise<Listing> {
    const response = await fetch(this.address("files"), { cache: "no-store" });
    if (!response.ok) throw new RejectedRequest(await errorMessage(response));
    return (await response.json()) as Listing;
  }

  /** Returns null if the file does not exist. */
  async read(name: string): Promise<{ bytes: Uint8Array; tag: string } | null> {
    const response = await fetch(this.fileAddress(name), { cache: "no-store" });
    if (response.status === 404) return null;
    if (!response.ok) throw new RejectedRequest(await errorMessage(response));
    return { bytes: new Uint8Array(await response.arrayBuffer()), tag: responseTag(response) };
  }

  /** Writes a file in place of the version with this tag; null: the file must not exist yet. */
  async write(name: string, bytes: Uint8Array, tag: string | null): Promise<WriteResult> {
    const headers: Record<string, string> = tag === null ? { "If-None-Match": "*" } : { "If-Match": `"${tag}"` };
    const response = await fetch(this.fileAddress(name), { method: "PUT", headers, body: bytes as BodyInit });
    if (response.status === 412) {
      const { tag: present } = await responseJson(response);
      return { ok: false, tag: typeof present === "string" ? present : null };
    }
    if (!response.ok) throw new RejectedRequest(await errorMessage(response));
    const written = await responseJson(response);
    return { ok: true, tag: String(written.tag) };
  }

  /**
   * Returns the complete message of segments with this number, of a kept run. Throws an error with a message.
   */
  async laws(run: string, number: number): Promise<Message> {
    const response = await fetch(this.address(`laws/${run}/${number}`), { cache: "no-store" }).catch(() => null);
    if (!response) throw new RejectedRequest(texts.folder.noAnswer);
    if (!response.ok) throw new RejectedRequest(await errorMessage(response));
    return readMessage(new Uint8Array(await response.arrayBuffer()));
  }

  /**
   * Reports changes as they come. Calls `begun` when some may have been missed, so that all files are listed
   * again. Returns when the server is silent or gone. It polls, because a response that does not end takes
   * one of the six connections that a browser has for all pages of a server.
   */
  async follow(begun: () => void, changed: (change: FolderChange) => void): Promise<void> {
    for (let at: number | null = null; ; await pause(POLL_MS)) {
      const changes: Changes | null = await this.changesSince(at).catch(() => null);
      if (!changes) return;
      if (changes.again) begun();
      changes.changed.forEach(changed);
      at = changes.at;
    }
  }

  /** null: it refuses. */
  private async changesSince(at: number | null): Promise<Changes | null> {
    const address = this.address(at === null ? "changes" : `changes?since=${at}`);
    const response = await fetch(address, { cache: "no-store", signal: AbortSignal.timeout(RESPONSE_TIMEOUT_MS) });
    return response.ok ? ((await response.json()) as Changes) : null;
  }

  private fileAddress(name: string): URL {
    return this.address(`file/${encodePath(name)}`);
  }
}

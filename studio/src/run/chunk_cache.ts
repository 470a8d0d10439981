// Columns of a long run that a page does not hold: fetched by stretches; the last few that were viewed are
// kept.

import type { Message } from "../core/message";
import { readChunk, type Chunk, type RunSection } from "./run_section";

/** Fetches the complete message of segments with this number. */
export type FetchLaws = (number: number) => Promise<Message>;

/** Some 70 MB. */
const MAX_CHUNKS = 16;
/** Pause after an error, so that a scrub does not repeat the request at each step. */
const RETRY_PAUSE_MS = 2000;

export class ChunkCache {
  private readonly here = new Map<RunSection, Chunk>();
  private readonly pendingFetch = new Map<RunSection, Promise<boolean>>();
  private requested: RunSection[] = [];
  private isFetching = false;
  private lastFailure_ms = -Infinity;
  private last: [RunSection, Chunk] | null = null;
  /** Called when some have been loaded, and why some have not. */
  onLoaded: () => void = () => {};
  failed: (why: string) => void = () => {};

  constructor(
    private readonly fetch: FetchLaws,
    private readonly most = MAX_CHUNKS,
  ) {}

  /** How many are kept. */
  get count(): number {
    return this.here.size;
  }

  /** Null: it is not here. */
  get(section: RunSection): Chunk | null {
    if (this.last?.[0] === section) return this.last[1];
    const chunk = this.here.get(section);
    if (!chunk) return null;
    this.put(section, chunk);
    return chunk;
  }

  /** Stores a chunk as the last one that was viewed. */
  private put(section: RunSection, chunk: Chunk): void {
    this.here.delete(section);
    this.here.set(section, chunk);
    this.last = [section, chunk];
    while (this.here.size > this.most) this.here.delete(this.here.keys().next().value!);
  }

  /** Fetches these one by one; earlier requests that are not in progress are dropped. */
  prefetch(sections: RunSection[]): void {
    this.requested = sections;
    if (!this.isFetching && performance.now() - this.lastFailure_ms > RETRY_PAUSE_MS) void this.work();
  }

  private async work(): Promise<void> {
    this.isFetching = true;
    for (let next = this.requested.shift(); next; next = this.requested.shift()) {
      if (!(await this.fetchNow(next))) this.requested = [];
    }
    this.isFetching = false;
  }

  /** Fetches one at once; returns true if it is then loaded. */
  async fetchNow(section: RunSection): Promise<boolean> {
    if (section.whole || this.here.has(section)) return true;
    const pendingFetch = this.pendingFetch.get(section) ?? this.fetchSection(section);
    this.pendingFetch.set(section, pendingFetch);
    return pendingFetch;
  }

  private async fetchSection(section: RunSection): Promise<boolean> {
    try {
      const chunk = readChunk(await this.fetch(section.number));
      // Data of another run would be joints of another motion.
      if (chunk.first !== section.first || chunk.count !== section.count || chunk.start_s[0] !== section.start_s) {
        throw new Error(`message ${section.number} belongs to another run`);
      }
      this.put(section, chunk);
      this.onLoaded();
      return true;
    } catch (error) {
      this.lastFailure_ms = performance.now();
      this.failed(error instanceof Error ? error.message : String(error));
      return false;
    } finally {
      this.pendingFetch.delete(section);
    }
  }
}

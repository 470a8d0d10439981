// Columns of a long run that a page does not hold: fetched by stretches; the last few that were viewed are
// kept.

import type { Message } from "../core/message";
import { chunkOf, type Chunk, type Stretch } from "./stretch";

/** Fetches the complete message of segments with this number. */
export type FetchLaws = (number: number) => Promise<Message>;

/** Some 70 MB. */
const MOST = 16;
/** Pause after an error, so that a scrub does not repeat the request at each step. */
const REST_MS = 2000;

export class Laws {
  private readonly here = new Map<Stretch, Chunk>();
  private readonly coming = new Map<Stretch, Promise<boolean>>();
  private wanted: Stretch[] = [];
  private works = false;
  private failed_ms = -Infinity;
  private last: [Stretch, Chunk] | null = null;
  /** Called when some have been loaded, and why some have not. */
  come: () => void = () => {};
  failed: (why: string) => void = () => {};

  constructor(
    private readonly fetch: FetchLaws,
    private readonly most = MOST,
  ) {}

  /** How many are kept. */
  get count(): number {
    return this.here.size;
  }

  /** Null: it is not here. */
  get(stretch: Stretch): Chunk | null {
    if (this.last?.[0] === stretch) return this.last[1];
    const chunk = this.here.get(stretch);
    if (!chunk) return null;
    this.put(stretch, chunk);
    return chunk;
  }

  /** Stores a chunk as the last one that was viewed. */
  private put(stretch: Stretch, chunk: Chunk): void {
    this.here.delete(stretch);
    this.here.set(stretch, chunk);
    this.last = [stretch, chunk];
    while (this.here.size > this.most) this.here.delete(this.here.keys().next().value!);
  }

  /** Fetches these one by one; earlier requests that are not in progress are dropped. */
  want(stretches: Stretch[]): void {
    this.wanted = stretches;
    if (!this.works && performance.now() - this.failed_ms > REST_MS) void this.work();
  }

  private async work(): Promise<void> {
    this.works = true;
    for (let next = this.wanted.shift(); next; next = this.wanted.shift()) {
      if (!(await this.need(next))) this.wanted = [];
    }
    this.works = false;
  }

  /** Fetches one at once; returns true if it is then loaded. */
  async need(stretch: Stretch): Promise<boolean> {
    if (stretch.whole || this.here.has(stretch)) return true;
    const coming = this.coming.get(stretch) ?? this.bring(stretch);
    this.coming.set(stretch, coming);
    return coming;
  }

  private async bring(stretch: Stretch): Promise<boolean> {
    try {
      const chunk = chunkOf(await this.fetch(stretch.number));
      // Data of another run would be joints of another motion.
      if (chunk.first !== stretch.first || chunk.count !== stretch.count || chunk.start_s[0] !== stretch.start_s) {
        throw new Error(`message ${stretch.number} is of another run`);
      }
      this.put(stretch, chunk);
      this.come();
      return true;
    } catch (fault) {
      this.failed_ms = performance.now();
      this.failed(fault instanceof Error ? fault.message : String(fault));
      return false;
    } finally {
      this.coming.delete(stretch);
    }
  }
}

// What came of variants: their runs by set-up, as long as they are to be had, and what holds of each by now.

import { MOST_BLOCKS, type Session } from "../../../core/session";
import type { Setup } from "../../../core/setup";
import type { Run } from "../../../run/run";
import { isWhole } from "./differences";

/** Only a run that is "done" or "stopped" is of the documents as they are now. */
export type Standing =
  | { is: "none" | "dropped"; run: null }
  | { is: "earlier"; run: Run; files: string[] }
  | { is: "failed"; run: Run; why: string }
  | { is: "stopped" | "done"; run: Run };

const keyOf = (setup: Readonly<Setup>): string => JSON.stringify(Object.entries(setup).sort());

const blocksOf = (run: Run): number => run.robots.reduce((sum, { segments }) => sum + segments.count, 0);

export class Results {
  /** The run that was made last is the last one. */
  private readonly runs = new Map<string, Run>();
  private readonly dropped = new Set<string>();

  constructor(
    private readonly session: Pick<Session, "origin" | "changedSince">,
    /** Runs go, the oldest first, when all together have more segments than this. */
    private readonly mostBlocks = MOST_BLOCKS,
  ) {}

  /** Keeps a run for variants of its set-up. */
  take(run: Run): void {
    const origin = this.session.origin(run);
    if (!origin) return;
    const key = keyOf(origin.setup);
    this.runs.delete(key);
    // Of a run that is too long for the page there are no blocks to compare.
    if (run.isLong) {
      this.dropped.add(key);
      return;
    }
    this.runs.set(key, run);
    this.dropped.delete(key);
    this.makeRoom();
  }

  private makeRoom(): void {
    let blocks = [...this.runs.values()].reduce((sum, run) => sum + blocksOf(run), 0);
    for (const [key, run] of this.runs) {
      if (blocks <= this.mostBlocks || this.runs.size === 1) return;
      blocks -= blocksOf(run);
      this.runs.delete(key);
      this.dropped.add(key);
    }
  }

  standing(setup: Readonly<Setup>): Standing {
    const key = keyOf(setup);
    const run = this.runs.get(key);
    if (!run) return { is: this.dropped.has(key) ? "dropped" : "none", run: null };
    const files = this.session.changedSince(run);
    if (files.length > 0) return { is: "earlier", run, files };
    if (run.failure) return { is: "failed", run, why: run.failure.message };
    return { is: isWhole(run) ? "done" : "stopped", run };
  }
}

/** Whether its figures are of what is now. */
export const isFresh = (standing: Standing): standing is { is: "stopped" | "done"; run: Run } =>
  standing.is === "done" || standing.is === "stopped";

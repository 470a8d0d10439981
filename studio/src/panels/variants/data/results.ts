// Results of variants: their runs by setup, as long as they are available, and the current status of each.

import { MAX_BLOCKS, type Session } from "../../../core/session";
import type { Setup } from "../../../core/setup";
import type { Run } from "../../../run/run";
import { isCompleteRun } from "./differences";

/** Status of a run; only "done" or "stopped" means that it is of the current documents. */
export type VariantStatus =
  | { is: "none" | "dropped"; run: null }
  | { is: "earlier"; run: Run; files: string[] }
  | { is: "failed"; run: Run; why: string }
  | { is: "stopped" | "done"; run: Run };

const setupKey = (setup: Readonly<Setup>): string => JSON.stringify(Object.entries(setup).sort());

const segmentTotal = (run: Run): number => run.robots.reduce((sum, { segments }) => sum + segments.count, 0);

export class Results {
  /** Runs in order; the latest one is the last. */
  private readonly runs = new Map<string, Run>();
  private readonly dropped = new Set<string>();

  constructor(
    private readonly session: Pick<Session, "origin" | "changedSince">,
    /** Limit on the segments of all runs; beyond it runs are dropped, the oldest first. */
    private readonly mostBlocks = MAX_BLOCKS,
  ) {}

  /** Keeps a run for variants with its setup. */
  accept(run: Run): void {
    const origin = this.session.origin(run);
    if (!origin) return;
    const key = setupKey(origin.setup);
    this.runs.delete(key);
    // A run that is too long for the page has no blocks to compare.
    if (run.isLong) {
      this.dropped.add(key);
      return;
    }
    this.runs.set(key, run);
    this.dropped.delete(key);
    this.dropOldRuns();
  }

  private dropOldRuns(): void {
    let blocks = [...this.runs.values()].reduce((sum, run) => sum + segmentTotal(run), 0);
    for (const [key, run] of this.runs) {
      if (blocks <= this.mostBlocks || this.runs.size === 1) return;
      blocks -= segmentTotal(run);
      this.runs.delete(key);
      this.dropped.add(key);
    }
  }

  standing(setup: Readonly<Setup>): VariantStatus {
    const key = setupKey(setup);
    const run = this.runs.get(key);
    if (!run) return { is: this.dropped.has(key) ? "dropped" : "none", run: null };
    const files = this.session.changedSince(run);
    if (files.length > 0) return { is: "earlier", run, files };
    if (run.error) return { is: "failed", run, why: run.error.message };
    return { is: isCompleteRun(run) ? "done" : "stopped", run };
  }
}

/** True if its results are current. */
export const isCurrent = (standing: VariantStatus): standing is { is: "stopped" | "done"; run: Run } =>
  standing.is === "done" || standing.is === "stopped";

// Runs variants one after another, until a run of the page's own, or the user, ends it.

import type { Session } from "../../../core/session";
import type { Running } from "../../../core/store";
import type { Results } from "./results";
import type { Variant } from "./variants_file";

export interface RunProgress extends Running {
  name: string;
}

export class Runner {
  /** Null: no variant runs. */
  runProgress: RunProgress | null = null;
  private turn = 0;

  constructor(
    private readonly session: Session,
    private readonly results: Results,
    private readonly changed: () => void,
  ) {}

  async run(variants: readonly Variant[]): Promise<void> {
    const turn = ++this.turn;
    for (const { name, setup } of variants) {
      this.tell({ name, done: 0, total: 0 });
      const run = await this.session.runComparison(setup, (running) => {
        if (turn === this.turn) this.tell({ name, ...running });
      });
      if (turn !== this.turn) return;
      if (!run) break;
      this.results.accept(run);
    }
    this.tell(null);
  }

  cancel(): void {
    if (!this.runProgress) return;
    ++this.turn;
    this.session.cancelRun();
    this.tell(null);
  }

  private tell(runProgress: RunProgress | null): void {
    this.runProgress = runProgress;
    this.changed();
  }
}

// Automatic runs while the user types: if the check has found no errors, and the last run was short.

import { Debounced } from "../core/debounced";
import type { Session } from "../core/session";
import type { Store } from "../core/store";

const MAX_AUTO_RUN_S = 1;
/** A script cannot be checked before it runs: it runs if the user pauses. */
const SCRIPT_PAUSE_MS = 600;
/** The check runs sooner with this option on. */
export const CHECK_PAUSE_MS = 150;

export class AutoRun {
  isEnabled = false;
  /** Computing time of the last run. */
  private duration_s = 0;
  private start_ms = 0;
  private isPending = false;
  private readonly pause = new Debounced(() => this.run());

  constructor(
    store: Store,
    private readonly session: Session,
    private readonly flush: () => void,
  ) {
    store.on("running", (running, before) => {
      if (running && !before) this.start_ms = performance.now();
    });
    store.on("run", () => {
      // A run that was loaded, not computed, has no computing time.
      if (store.get("running")) this.duration_s = (performance.now() - this.start_ms) / 1000;
    });
  }

  get isTooSlow(): boolean {
    return this.duration_s > MAX_AUTO_RUN_S;
  }

  get isActive(): boolean {
    return this.isEnabled && !this.isTooSlow && this.session.canRun;
  }

  onEdit(isScript: boolean): void {
    this.isPending = this.isActive;
    if (this.isPending && isScript) this.pause.after(SCRIPT_PAUSE_MS);
  }

  checked(hasErrors: boolean): void {
    if (this.isPending && !hasErrors && this.isActive) this.run();
  }

  private run(): void {
    this.isPending = false;
    this.flush();
    void this.session.run();
  }
}

// Automatic runs while the user types: if the check has found no errors, and the last run was short.

import { Debounced } from "../core/debounced";
import type { Session } from "../core/session";
import type { Store } from "../core/store";

const SHORT_S = 1;
/** A script cannot be checked before it runs: it runs if the user pauses. */
const SCRIPT_PAUSE_MS = 600;
/** The check runs sooner with this option on. */
export const CHECK_PAUSE_MS = 150;

export class AutoRun {
  isOn = false;
  /** Computing time of the last run. */
  private took_s = 0;
  private began_ms = 0;
  private isDue = false;
  private readonly pause = new Debounced(() => this.run());

  constructor(
    store: Store,
    private readonly session: Session,
    private readonly flush: () => void,
  ) {
    store.on("running", (running, before) => {
      if (running && !before) this.began_ms = performance.now();
    });
    store.on("run", () => {
      // A run that was loaded, not computed, has no computing time.
      if (store.get("running")) this.took_s = (performance.now() - this.began_ms) / 1000;
    });
  }

  get isTooSlow(): boolean {
    return this.took_s > SHORT_S;
  }

  get isActive(): boolean {
    return this.isOn && !this.isTooSlow && this.session.canRun;
  }

  edited(isScript: boolean): void {
    this.isDue = this.isActive;
    if (this.isDue && isScript) this.pause.after(SCRIPT_PAUSE_MS);
  }

  checked(hasErrors: boolean): void {
    if (this.isDue && !hasErrors && this.isActive) this.run();
  }

  private run(): void {
    this.isDue = false;
    this.flush();
    void this.session.run();
  }
}

// Action that waits until it has not been requested again for a while.

export class Debounced {
  private timer: ReturnType<typeof setTimeout> | null = null;

  constructor(private readonly action: () => void) {}

  /** Returns true if the action is pending. */
  get isDue(): boolean {
    return this.timer !== null;
  }

  /** Runs it after a delay; of several calls the last one counts. */
  after(delay_ms: number): void {
    this.cancel();
    this.timer = setTimeout(() => {
      this.timer = null;
      this.action();
    }, delay_ms);
  }

  /** Runs a pending action at once. */
  flush(): void {
    if (this.timer === null) return;
    this.cancel();
    this.action();
  }

  cancel(): void {
    if (this.timer !== null) clearTimeout(this.timer);
    this.timer = null;
  }
}

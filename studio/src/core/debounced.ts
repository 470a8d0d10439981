// An action that waits until it has not been asked for again for a while.

export class Debounced {
  private timer: ReturnType<typeof setTimeout> | null = null;

  constructor(private readonly action: () => void) {}

  /** Whether it waits to be done. */
  get isDue(): boolean {
    return this.timer !== null;
  }

  /** Does it after a time; of several calls the last one counts. */
  after(delay_ms: number): void {
    this.cancel();
    this.timer = setTimeout(() => {
      this.timer = null;
      this.action();
    }, delay_ms);
  }

  /** Does at once what is due. */
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

// Time of the next picture: set by the window, or, while a headset shows pictures, by the headset, which may
// stop the window's.

export class AnimationFrames {
  private readonly waiting = new Map<number, (now_ms: number) => void>();
  private last = 0;
  private asked = 0;
  /** Time of the headset's last picture; null: the window sets it. */
  private headsetFrame_ms: number | null = null;

  /** Returns the time in the clock of the frames. */
  get now_ms(): number {
    return this.headsetFrame_ms ?? performance.now();
  }

  /** Calls back once, at the next picture; returns a function that cancels it. */
  request(callback: (now_ms: number) => void): number {
    this.waiting.set(++this.last, callback);
    this.ask();
    return this.last;
  }

  cancel(request: number): void {
    this.waiting.delete(request);
  }

  private ask(): void {
    if (this.headsetFrame_ms !== null || this.waiting.size === 0) return;
    this.asked ||= requestAnimationFrame((now_ms) => this.tell(now_ms));
  }

  private tell(now_ms: number): void {
    this.asked = 0;
    const dueCallbacks = [...this.waiting.values()];
    this.waiting.clear();
    for (const callback of dueCallbacks) callback(now_ms);
  }

  /** Handles a picture of another display; the window's are ignored until release(). */
  drive(now_ms: number): void {
    cancelAnimationFrame(this.asked);
    this.headsetFrame_ms = now_ms;
    this.tell(now_ms);
  }

  /** Returns the timing to the window. */
  release(): void {
    this.headsetFrame_ms = null;
    this.ask();
  }
}

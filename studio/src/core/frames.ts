// When the next picture is due: told by the window, or, while one is shown there, by a headset, which may stop the window's.

export class Frames {
  private readonly waiting = new Map<number, (now_ms: number) => void>();
  private last = 0;
  private asked = 0;
  /** When the headset's last picture was due; null: the window tells. */
  private shown_ms: number | null = null;

  /** In the time that frames are told in. */
  get now_ms(): number {
    return this.shown_ms ?? performance.now();
  }

  /** Calls back once, at the next picture; returns what cancels it. */
  request(callback: (now_ms: number) => void): number {
    this.waiting.set(++this.last, callback);
    this.ask();
    return this.last;
  }

  cancel(request: number): void {
    this.waiting.delete(request);
  }

  private ask(): void {
    if (this.shown_ms !== null || this.waiting.size === 0) return;
    this.asked ||= requestAnimationFrame((now_ms) => this.tell(now_ms));
  }

  private tell(now_ms: number): void {
    this.asked = 0;
    const due = [...this.waiting.values()];
    this.waiting.clear();
    for (const callback of due) callback(now_ms);
  }

  /** A picture elsewhere is due; the window's count no more until release(). */
  drive(now_ms: number): void {
    cancelAnimationFrame(this.asked);
    this.shown_ms = now_ms;
    this.tell(now_ms);
  }

  /** The window tells again. */
  release(): void {
    this.shown_ms = null;
    this.ask();
  }
}

// Stretch of time that scrubber and charts show.

const MIN_SPAN_S = 1e-4;

export class TimeWindow {
  start_s = 0;
  end_s = 0;
  total_s = 0;
  private readonly listeners = new Set<() => void>();

  get span_s(): number {
    return this.end_s - this.start_s;
  }

  get isComplete(): boolean {
    return this.span_s >= this.total_s;
  }

  on(listener: () => void): void {
    this.listeners.add(listener);
  }

  /** Starts with another run or robot; if its time differs, all of it is shown. */
  begin(total_s: number): void {
    const same = total_s === this.total_s;
    this.total_s = total_s;
    if (same) this.put(this.start_s, this.end_s);
    else this.put(0, total_s);
  }

  reset(): void {
    this.set(0, this.total_s);
  }

  /** Shows as much of it as possible, and keeps the span. */
  set(start_s: number, end_s: number): void {
    const span_s = Math.min(Math.max(end_s - start_s, Math.min(MIN_SPAN_S, this.total_s)), this.total_s);
    const from_s = Math.min(Math.max(start_s, 0), this.total_s - span_s);
    if (from_s !== this.start_s || from_s + span_s !== this.end_s) this.put(from_s, from_s + span_s);
  }

  /** Zooms; a factor below 1 shows less, and `about_s` keeps its position. */
  zoom(about_s: number, factor: number): void {
    const start_s = about_s - (about_s - this.start_s) * factor;
    this.set(start_s, start_s + this.span_s * factor);
  }

  pan(by_s: number): void {
    this.set(this.start_s + by_s, this.end_s + by_s);
  }

  /** Brings an instant into view, at a tenth from the edge that it is beyond. */
  show(t_s: number): void {
    const margin_s = this.span_s / 10;
    if (t_s < this.start_s) this.pan(t_s - this.end_s + margin_s);
    else if (t_s > this.end_s) this.pan(t_s - this.start_s - margin_s);
  }

  private put(start_s: number, end_s: number): void {
    this.start_s = start_s;
    this.end_s = end_s;
    for (const listener of this.listeners) listener();
  }
}

/** Returns "round" instants in a stretch of time, about `count` of them. */
export function ticks(start_s: number, end_s: number, count: number): { at_s: number[]; digits: number } {
  const minStep_s = (end_s - start_s) / Math.max(count, 1);
  if (!(minStep_s > 0)) return { at_s: [], digits: 0 };
  const steps = [1, 2, 5, 10, 15, 30, 60, 120, 300, 600, 900, 1800, 3600, 7200, 18000, 36000, 86400];
  const power = 10 ** Math.floor(Math.log10(minStep_s));
  const below = [1, 2, 5, 10].map((step) => step * power).find((step) => step >= minStep_s)!;
  const step_s = minStep_s < 1 ? below : (steps.find((step) => step >= minStep_s) ?? below);
  const at_s: number[] = [];
  for (let i = Math.ceil(start_s / step_s); i * step_s <= end_s; ++i) at_s.push(i * step_s);
  return { at_s, digits: Math.max(0, Math.ceil(-Math.log10(step_s) - 1e-9)) };
}

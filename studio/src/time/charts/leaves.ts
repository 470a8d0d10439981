// Lowest and highest values of runs of segments, computed in slices while the page stays responsive. A chart
// of a long stretch of time then reads few numbers and misses no peak.

import type { Segments } from "../../run/segments";
import { Probe, type Group } from "./probe";

const LEAF = 8;
const SLICE_MS = 10;

export class Leaves {
  readonly probe: Probe;
  readonly low: Float32Array;
  readonly high: Float32Array;
  private built = 0;
  private readonly count: number;

  /** `done` is called once all are computed; not if they are available at once. */
  constructor(
    private readonly segments: Segments,
    group: Group,
    private readonly done: () => void,
  ) {
    this.probe = new Probe(segments, group);
    // For a long run the data is not loaded.
    this.count = segments.isLong ? 0 : Math.ceil(segments.count / LEAF);
    this.low = new Float32Array(this.count * this.probe.width).fill(Infinity);
    this.high = new Float32Array(this.count * this.probe.width).fill(-Infinity);
    this.slice();
    if (!this.ready) setTimeout(this.next);
  }

  get ready(): boolean {
    return this.built >= this.count;
  }

  private readonly next = () => {
    this.slice();
    if (this.ready) this.done();
    else setTimeout(this.next);
  };

  private slice(): void {
    const until_ms = performance.now() + SLICE_MS;
    while (this.built < this.count && performance.now() < until_ms) {
      for (let i = 0; i < 32 && this.built < this.count; ++i) this.build(this.built++);
    }
  }

  private build(leaf: number): void {
    const { probe } = this;
    const last = Math.min((leaf + 1) * LEAF, this.segments.count);
    for (let index = leaf * LEAF; index < last; ++index) {
      const spot = probe.spot(index);
      if (spot && spot.part.duration_s > 0) probe.widen(spot, this.low, this.high, leaf * probe.width);
    }
  }

  /** Widens `low` and `high` by the values of segments from `first` to before `end`. */
  widen(first: number, end: number, low: Float32Array, high: Float32Array): void {
    let index = first;
    while (index < end) {
      if (this.count > 0 && index % LEAF === 0 && index + LEAF <= end) {
        this.addLeaf(index / LEAF, low, high);
        index += LEAF;
      } else {
        const spot = this.probe.spot(index++);
        if (spot && spot.part.duration_s > 0) this.probe.widen(spot, low, high, 0);
      }
    }
  }

  private addLeaf(leaf: number, low: Float32Array, high: Float32Array): void {
    const { width } = this.probe;
    for (let j = 0; j < width; ++j) {
      low[j] = Math.min(low[j], this.low[leaf * width + j]);
      high[j] = Math.max(high[j], this.high[leaf * width + j]);
    }
  }
}

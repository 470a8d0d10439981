// Lowest and highest values of runs of segments, computed in slices while the page stays responsive. A chart
// of a long stretch of time then reads few numbers and misses no peak.

import type { Segments } from "../../run/segments";
import { CurveSampler, type Group } from "./curve_sampler";

const SEGMENTS_PER_LEAF = 8;
const SLICE_MS = 10;

export class ExtremaTree {
  readonly probe: CurveSampler;
  readonly low: Float32Array;
  readonly high: Float32Array;
  private builtCount = 0;
  private readonly count: number;

  /** `done` is called once all are computed; not if they are available at once. */
  constructor(
    private readonly segments: Segments,
    group: Group,
    private readonly done: () => void,
  ) {
    this.probe = new CurveSampler(segments, group);
    // For a long run the data is not loaded.
    this.count = segments.isLong ? 0 : Math.ceil(segments.count / SEGMENTS_PER_LEAF);
    this.low = new Float32Array(this.count * this.probe.width).fill(Infinity);
    this.high = new Float32Array(this.count * this.probe.width).fill(-Infinity);
    this.slice();
    if (!this.ready) setTimeout(this.next);
  }

  get ready(): boolean {
    return this.builtCount >= this.count;
  }

  private readonly next = () => {
    this.slice();
    if (this.ready) this.done();
    else setTimeout(this.next);
  };

  private slice(): void {
    const deadline_ms = performance.now() + SLICE_MS;
    while (this.builtCount < this.count && performance.now() < deadline_ms) {
      for (let i = 0; i < 32 && this.builtCount < this.count; ++i) this.build(this.builtCount++);
    }
  }

  private build(leaf: number): void {
    const { probe } = this;
    const last = Math.min((leaf + 1) * SEGMENTS_PER_LEAF, this.segments.count);
    for (let index = leaf * SEGMENTS_PER_LEAF; index < last; ++index) {
      const segmentRef = probe.segmentRef(index);
      if (segmentRef && segmentRef.part.duration_s > 0) probe.expand(segmentRef, this.low, this.high, leaf * probe.width);
    }
  }

  /** Widens `low` and `high` by the values of segments from `first` to before `end`. */
  expand(first: number, end: number, low: Float32Array, high: Float32Array): void {
    let index = first;
    while (index < end) {
      if (this.count > 0 && index % SEGMENTS_PER_LEAF === 0 && index + SEGMENTS_PER_LEAF <= end) {
        this.addLeaf(index / SEGMENTS_PER_LEAF, low, high);
        index += SEGMENTS_PER_LEAF;
      } else {
        const segmentRef = this.probe.segmentRef(index++);
        if (segmentRef && segmentRef.part.duration_s > 0) this.probe.expand(segmentRef, low, high, 0);
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

// Straight parts in space, and a search for the nearest one to a point: a tree of boxes around runs of
// neighbours, halved at each level.

/** Consecutive parts: six coordinates (mm) for each. */
export class LineSegmentTree {
  /** Box of each node of the tree: three lowest and three highest coordinates. */
  private readonly boxes: Float64Array;
  private readonly leaves: number;

  constructor(
    private readonly ends: Float64Array,
    readonly count = ends.length / 6,
  ) {
    this.leaves = 2 ** Math.ceil(Math.log2(Math.max(Math.ceil(count / SEGMENTS_PER_LEAF), 1)));
    this.boxes = new Float64Array(6 * 2 * this.leaves);
    for (let node = 2 * this.leaves - 1; node >= 1; --node) this.enclose(node);
  }

  private enclose(node: number): void {
    const { boxes, ends, leaves, count } = this;
    const box = boxes.subarray(6 * node, 6 * node + 6);
    box.fill(Infinity, 0, 3).fill(-Infinity, 3);
    const expand = (x: number, axis: number) => {
      box[axis] = Math.min(box[axis], x);
      box[3 + axis] = Math.max(box[3 + axis], x);
    };
    if (node >= leaves) {
      const first = SEGMENTS_PER_LEAF * (node - leaves);
      for (let i = 6 * first; i < 6 * Math.min(first + SEGMENTS_PER_LEAF, count); ++i) expand(ends[i], i % 3);
      return;
    }
    for (const child of [2 * node, 2 * node + 1]) for (let i = 0; i < 6; ++i) expand(boxes[6 * child + i], i % 3);
  }

  /** Returns the distance to the nearest part, mm; Infinity: none. */
  distanceTo(x: number, y: number, z: number): number {
    return Math.sqrt(this.search(1, x, y, z, Infinity));
  }

  /** Returns the smallest square of the distance in a node, or `best` if that is smaller. */
  private search(node: number, x: number, y: number, z: number, best: number): number {
    if (node >= this.leaves) {
      const first = SEGMENTS_PER_LEAF * (node - this.leaves);
      for (let i = first; i < Math.min(first + SEGMENTS_PER_LEAF, this.count); ++i) best = Math.min(best, this.square(i, x, y, z));
      return best;
    }
    const [left, right] = [this.squaredDistanceToBox(2 * node, x, y, z), this.squaredDistanceToBox(2 * node + 1, x, y, z)];
    const [near, far] = left <= right ? [2 * node, 2 * node + 1] : [2 * node + 1, 2 * node];
    if (Math.min(left, right) < best) best = this.search(near, x, y, z, best);
    if (Math.max(left, right) < best) best = this.search(far, x, y, z, best);
    return best;
  }

  private squaredDistanceToBox(node: number, x: number, y: number, z: number): number {
    const { boxes } = this;
    const at = 6 * node;
    const dx = Math.max(boxes[at] - x, 0, x - boxes[at + 3]);
    const dy = Math.max(boxes[at + 1] - y, 0, y - boxes[at + 4]);
    const dz = Math.max(boxes[at + 2] - z, 0, z - boxes[at + 5]);
    return dx * dx + dy * dy + dz * dz;
  }

  private square(section: number, x: number, y: number, z: number): number {
    const { ends } = this;
    const at = 6 * section;
    const [ux, uy, uz] = [ends[at + 3] - ends[at], ends[at + 4] - ends[at + 1], ends[at + 5] - ends[at + 2]];
    const [px, py, pz] = [x - ends[at], y - ends[at + 1], z - ends[at + 2]];
    const size = ux * ux + uy * uy + uz * uz;
    const share = size > 0 ? Math.min(Math.max((px * ux + py * uy + pz * uz) / size, 0), 1) : 0;
    const [dx, dy, dz] = [px - share * ux, py - share * uy, pz - share * uz];
    return dx * dx + dy * dy + dz * dz;
  }
}

const SEGMENTS_PER_LEAF = 8;

// Data of the tables for each block, as columns; made once for each robot of a run.

import type { Robot } from "../../../run/run";
import { decodeKind, decodeLimitAxis, decodeLimit } from "../../../run/segments";

export class BlockTable {
  readonly count: number;
  readonly duration_s: Float64Array;
  readonly length_mm: Float64Array;
  /** Highest programmed feed, mm/min, or deg/min if the block has no length; 0: a rapid or a dwell. */
  readonly feed_per_min: Float32Array;
  readonly line: Uint32Array;
  readonly file: Uint32Array;
  /**
   * Values of the longest segment: indices into moveKinds and limitKinds, and the axis of the limit (-1:
   * none).
   */
  readonly kind: Uint8Array;
  readonly limit: Uint8Array;
  readonly axis: Int8Array;
  /** The time of all blocks. */
  total_s = 0;

  constructor(robot: Robot) {
    const count = robot.blocks.tabled;
    this.count = count;
    this.duration_s = new Float64Array(count);
    this.length_mm = new Float64Array(count);
    this.feed_per_min = new Float32Array(count);
    this.line = new Uint32Array(count);
    this.file = new Uint32Array(count);
    this.kind = new Uint8Array(count);
    this.limit = new Uint8Array(count);
    this.axis = new Int8Array(count);
    this.fill(robot);
  }

  private fill({ blocks, segments }: Robot): void {
    let block = -1;
    let next = 0;
    let longest_s = 0;
    for (const chunk of segments.chunks) {
      for (let i = 0; i < chunk.count; ++i) {
        const duration_s = chunk.duration_s[i];
        if (chunk.first + i === next) {
          ++block;
          next = blocks.end(block);
          longest_s = -1;
          this.line[block] = chunk.line[i];
          this.file[block] = chunk.file[i];
        }
        this.duration_s[block] += duration_s;
        this.length_mm[block] += chunk.length_mm[i];
        this.feed_per_min[block] = Math.max(this.feed_per_min[block], chunk.feed_per_min[i]);
        this.total_s += duration_s;
        if (duration_s <= longest_s) continue;
        longest_s = duration_s;
        const flags = chunk.flags[i];
        this.kind[block] = decodeKind(flags);
        this.limit[block] = decodeLimit(flags);
        this.axis[block] = decodeLimitAxis(flags);
      }
    }
  }

  /** Along the path, mm/s. */
  meanSpeed_mm_s(block: number): number {
    return this.duration_s[block] > 0 ? this.length_mm[block] / this.duration_s[block] : 0;
  }
}

const known = new WeakMap<Robot, BlockTable>();

export function cachedBlockTable(robot: Robot): BlockTable {
  const table = known.get(robot) ?? new BlockTable(robot);
  known.set(robot, table);
  return table;
}

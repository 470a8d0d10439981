// Drawn path of one robot for the view: vertices counted over all stretches, in the work frame.

import { Box3, Vector3 } from "three";
import { lastIndex } from "../../run/search";
import { isRapid, type Segments } from "../../run/segments";
import type { Stretch } from "../../run/stretch";

/** Vertices in a row of their textures. */
export const ROW = 4096;

/** Vertices of one stretch: from one to before another, the first of which is number `vertex` of all. */
export interface Vertices {
  stretch: Stretch;
  from: number;
  to: number;
  vertex: number;
}

export class PathData {
  count = 0;
  /** Bounds of all vertices, and of those that do not end a rapid move (mm). */
  readonly bounds = new Box3();
  readonly cutBounds = new Box3();
  /** Number of the first vertex of each stretch. */
  private readonly firsts: number[] = [];

  constructor(readonly segments: Segments) {
    this.grow();
  }

  /** Adds the data that has arrived since. */
  grow(): void {
    const { stretches } = this.segments;
    for (let k = this.firsts.length; k < stretches.length; ++k) {
      this.firsts.push(this.count);
      this.count += stretches[k].vertices;
      this.include(stretches[k]);
    }
  }

  private include(stretch: Stretch): void {
    const { vertex_mm } = stretch;
    const point = new Vector3();
    for (let i = 0; i < stretch.vertices; ++i) {
      point.set(vertex_mm[3 * i], vertex_mm[3 * i + 1], vertex_mm[3 * i + 2]);
      this.bounds.expandByPoint(point);
      if (!isRapid(stretch.flagsOf(i))) this.cutBounds.expandByPoint(point);
    }
  }

  /** Returns vertices from one to before another, stretch by stretch. */
  *vertices(from: number, to: number): Generator<Vertices> {
    const { stretches } = this.segments;
    const first = Math.max(lastIndex(this.firsts.length, (i) => this.firsts[i] <= from), 0);
    for (let k = first; k < this.firsts.length && this.firsts[k] < to; ++k) {
      const begin = Math.max(from, this.firsts[k]);
      const end = Math.min(to, this.firsts[k] + stretches[k].vertices);
      if (begin < end) yield { stretch: stretches[k], from: begin - this.firsts[k], to: end - this.firsts[k], vertex: begin };
    }
  }

  /** Returns x, y, z (mm) and time (s) of vertices from one to before another, for a texture of full rows. */
  texels(from: number, to: number): Float32Array {
    const texels = new Float32Array(4 * ROW * rowsOf(to - from));
    for (const { stretch, from: begin, to: end, vertex } of this.vertices(from, to)) {
      const { vertex_mm } = stretch;
      let at = 4 * (vertex - from);
      for (let i = begin; i < end; ++i, at += 4) {
        texels[at] = vertex_mm[3 * i];
        texels[at + 1] = vertex_mm[3 * i + 1];
        texels[at + 2] = vertex_mm[3 * i + 2];
        texels[at + 3] = stretch.time_s(i);
      }
    }
    return texels;
  }

  /** Returns the stretch of a vertex, and its index there. */
  private locate(vertex: number): [Stretch, number] {
    const { stretches } = this.segments;
    const k = lastIndex(this.firsts.length, (i) => this.firsts[i] <= vertex);
    return [stretches[k], vertex - this.firsts[k]];
  }

  point(vertex: number, into = new Vector3()): Vector3 {
    const [stretch, i] = this.locate(vertex);
    return into.fromArray(stretch.vertex_mm, 3 * i);
  }

  time_s(vertex: number): number {
    const [stretch, i] = this.locate(vertex);
    return stretch.time_s(i);
  }

  /** Returns the segment that the part before a vertex belongs to. */
  segmentOf(vertex: number): number {
    const [stretch, i] = this.locate(vertex);
    return stretch.segmentOf(i);
  }

  /** Returns the flags of that segment, as far as loaded. */
  flagsOf(vertex: number): number {
    const [stretch, i] = this.locate(vertex);
    return stretch.flagsOf(i);
  }

  isRapid(vertex: number): boolean {
    return isRapid(this.flagsOf(vertex));
  }

  /** Returns the vertex that ends the part active at a time; `count` after the last. */
  at(t_s: number): number {
    return lastIndex(this.count, (vertex) => this.time_s(vertex) <= t_s) + 1;
  }

  /**
   * Returns the vertices that end parts of the segments from `first` to before `end`: a range without its
   * end.
   */
  rangeOf(first: number, end: number): [number, number] {
    return [this.firstOf(first), this.firstOf(end)];
  }

  private firstOf(segment: number): number {
    const { stretches, count } = this.segments;
    if (segment >= count) return this.count;
    const k = lastIndex(stretches.length, (i) => stretches[i].first <= segment);
    return this.firsts[k] + stretches[k].firstVertexOf(segment);
  }
}

/** Returns the rows of a texture of so many vertices. */
export const rowsOf = (count: number): number => Math.max(1, Math.ceil(count / ROW));

// The drawn way of one robot as the view needs it: vertices counted over all chunks, in the work frame.

import { Box3, Vector3 } from "three";
import { lastIndex } from "../../run/search";
import { isRapid, type Chunk, type Segments } from "../../run/segments";

/** Vertices in a row of the textures that hold them. */
export const ROW = 4096;


export class PathData {
  readonly count: number;
  /** Of all vertices, and of those that no rapid move ends at (mm). */
  readonly bounds = new Box3();
  readonly cutBounds = new Box3();
  /** Number of the first vertex of each chunk. */
  private readonly firsts: number[] = [];

  constructor(readonly segments: Segments) {
    let count = 0;
    for (const chunk of segments.chunks) {
      this.firsts.push(count);
      count += chunk.vertex_s.length;
      this.include(chunk);
    }
    this.count = count;
  }

  private include({ vertex_mm, vertex_segment, flags }: Chunk): void {
    const point = new Vector3();
    for (let i = 0; i < vertex_segment.length; ++i) {
      point.set(vertex_mm[3 * i], vertex_mm[3 * i + 1], vertex_mm[3 * i + 2]);
      this.bounds.expandByPoint(point);
      if (!isRapid(flags[vertex_segment[i]])) this.cutBounds.expandByPoint(point);
    }
  }

  /** x, y, z (mm) and time (s) of each vertex, for a texture of whole rows. */
  texels(): Float32Array {
    const texels = new Float32Array(4 * ROW * this.rows);
    this.segments.chunks.forEach((chunk, k) => {
      let at = 4 * this.firsts[k];
      for (let i = 0; i < chunk.vertex_s.length; ++i, at += 4) {
        texels[at] = chunk.vertex_mm[3 * i];
        texels[at + 1] = chunk.vertex_mm[3 * i + 1];
        texels[at + 2] = chunk.vertex_mm[3 * i + 2];
        texels[at + 3] = chunk.vertex_s[i];
      }
    });
    return texels;
  }

  get rows(): number {
    return Math.max(1, Math.ceil(this.count / ROW));
  }

  /** The chunk of a vertex, and its place there. */
  private locate(vertex: number): [Chunk, number] {
    const { chunks } = this.segments;
    const k = lastIndex(chunks.length, (i) => this.firsts[i] <= vertex);
    return [chunks[k], vertex - this.firsts[k]];
  }

  point(vertex: number, into = new Vector3()): Vector3 {
    const [chunk, i] = this.locate(vertex);
    return into.fromArray(chunk.vertex_mm, 3 * i);
  }

  time_s(vertex: number): number {
    const [chunk, i] = this.locate(vertex);
    return chunk.vertex_s[i];
  }

  /** The segment whose way the piece before a vertex belongs to. */
  segmentOf(vertex: number): number {
    const [chunk, i] = this.locate(vertex);
    return chunk.first + chunk.vertex_segment[i];
  }

  isRapid(vertex: number): boolean {
    const [chunk, i] = this.locate(vertex);
    return isRapid(chunk.flags[chunk.vertex_segment[i]]);
  }

  /** The vertex that ends the piece under way at a time; `count` behind the last. */
  at(t_s: number): number {
    return lastIndex(this.count, (vertex) => this.time_s(vertex) <= t_s) + 1;
  }

  /** Vertices that end pieces of the segments from `first` to before `end`: from the one to before the other. */
  rangeOf(first: number, end: number): [number, number] {
    return [this.firstOf(first), this.firstOf(end)];
  }

  private firstOf(segment: number): number {
    const { chunks, count } = this.segments;
    if (segment >= count) return this.count;
    const k = lastIndex(chunks.length, (i) => chunks[i].first <= segment);
    const inside = segment - chunks[k].first;
    const vertices = chunks[k].vertex_segment;
    return this.firsts[k] + lastIndex(vertices.length, (i) => vertices[i] < inside) + 1;
  }
}

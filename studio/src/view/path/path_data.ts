// Drawn path of one robot for the view: vertices counted over all stretches, in the work frame.

import { Box3, Vector3 } from "three";
import { lastIndex } from "../../run/search";
import { isRapid, type Segments } from "../../run/segments";
import type { RunSection } from "../../run/run_section";

/** Vertices in a row of their textures. */
export const ROW = 4096;

/** Vertices of one stretch: from one to before another, the first of which is number `vertex` of all. */
export interface Vertices {
  section: RunSection;
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
    const { sections } = this.segments;
    for (let k = this.firsts.length; k < sections.length; ++k) {
      this.firsts.push(this.count);
      this.count += sections[k].vertices;
      this.include(sections[k]);
    }
  }

  private include(section: RunSection): void {
    const { vertex_mm } = section;
    const point = new Vector3();
    for (let i = 0; i < section.vertices; ++i) {
      point.set(vertex_mm[3 * i], vertex_mm[3 * i + 1], vertex_mm[3 * i + 2]);
      this.bounds.expandByPoint(point);
      if (!isRapid(section.vertexFlags(i))) this.cutBounds.expandByPoint(point);
    }
  }

  /** Returns vertices from one to before another, stretch by stretch. */
  *vertices(from: number, to: number): Generator<Vertices> {
    const { sections } = this.segments;
    const first = Math.max(lastIndex(this.firsts.length, (i) => this.firsts[i] <= from), 0);
    for (let k = first; k < this.firsts.length && this.firsts[k] < to; ++k) {
      const begin = Math.max(from, this.firsts[k]);
      const end = Math.min(to, this.firsts[k] + sections[k].vertices);
      if (begin < end) yield { section: sections[k], from: begin - this.firsts[k], to: end - this.firsts[k], vertex: begin };
    }
  }

  /** Returns x, y, z (mm) and time (s) of vertices from one to before another, for a texture of full rows. */
  texels(from: number, to: number): Float32Array {
    const texels = new Float32Array(4 * ROW * rowCount(to - from));
    for (const { section, from: begin, to: end, vertex } of this.vertices(from, to)) {
      const { vertex_mm } = section;
      let at = 4 * (vertex - from);
      for (let i = begin; i < end; ++i, at += 4) {
        texels[at] = vertex_mm[3 * i];
        texels[at + 1] = vertex_mm[3 * i + 1];
        texels[at + 2] = vertex_mm[3 * i + 2];
        texels[at + 3] = section.time_s(i);
      }
    }
    return texels;
  }

  /** Returns the stretch of a vertex, and its index there. */
  private locate(vertex: number): [RunSection, number] {
    const { sections } = this.segments;
    const k = lastIndex(this.firsts.length, (i) => this.firsts[i] <= vertex);
    return [sections[k], vertex - this.firsts[k]];
  }

  point(vertex: number, into = new Vector3()): Vector3 {
    const [section, i] = this.locate(vertex);
    return into.fromArray(section.vertex_mm, 3 * i);
  }

  time_s(vertex: number): number {
    const [section, i] = this.locate(vertex);
    return section.time_s(i);
  }

  /** Returns the segment that the part before a vertex belongs to. */
  vertexSegment(vertex: number): number {
    const [section, i] = this.locate(vertex);
    return section.vertexSegment(i);
  }

  /** Returns the flags of that segment, as far as loaded. */
  vertexFlags(vertex: number): number {
    const [section, i] = this.locate(vertex);
    return section.vertexFlags(i);
  }

  isRapid(vertex: number): boolean {
    return isRapid(this.vertexFlags(vertex));
  }

  /** Returns the vertex that ends the part active at a time; `count` after the last. */
  at(t_s: number): number {
    return lastIndex(this.count, (vertex) => this.time_s(vertex) <= t_s) + 1;
  }

  /**
   * Returns the vertices that end parts of the segments from `first` to before `end`: a range without its
   * end.
   */
  vertexRange(first: number, end: number): [number, number] {
    return [this.firstOf(first), this.firstOf(end)];
  }

  private firstOf(segment: number): number {
    const { sections, count } = this.segments;
    if (segment >= count) return this.count;
    const k = lastIndex(sections.length, (i) => sections[i].first <= segment);
    return this.firsts[k] + sections[k].firstVertex(segment);
  }
}

/** Returns the rows of a texture of so many vertices. */
export const rowCount = (count: number): number => Math.max(1, Math.ceil(count / ROW));

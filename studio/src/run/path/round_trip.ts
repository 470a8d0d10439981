// Round trip of a path: it was written as a program, the program has run, and the path of the run is compared
// with it.

import { isRapid, type Segments } from "../segments";
import { sampleArc } from "./path_arc";
import type { PathTraversal } from "./path_traversal";
import { LineSegmentTree } from "./line_segment_tree";
import { between, distance, type Vector } from "./vector";

export interface RoundTrip {
  /**
   * Largest distance of the path of the run from the given path, mm, and of the given path from that of the
   * run.
   */
  runDeviation_mm: number;
  pathDeviation_mm: number;
}

/** Max deviation of chords from their arcs. */
const CHORD_MM = 1e-4;
/** Distance between the points at which long lines are also compared. */
const STEP_MM = 1;
const MAX_STEPS = 32;
/** Distance from the path's first point at which a run is on the path. */
const ON_PATH_MM = 0.1;
/** Max number of compared points; beyond it only samples are compared. */
const MAX_POINTS = 400_000;

/** List of points with the parts between them. */
class Polyline {
  readonly ends: number[] = [];
  readonly places: number[] = [];

  add(from: Vector, to: Vector): void {
    this.ends.push(...from, ...to);
    const steps = Math.min(Math.ceil(distance(from, to) / STEP_MM), MAX_STEPS);
    for (let i = 0; i < steps; ++i) this.places.push(...between(from, to, i / steps));
    this.places.push(...to);
  }

  toSegmentTree(): LineSegmentTree {
    return new LineSegmentTree(Float64Array.from(this.ends));
  }

  /** Returns the largest distance of its points from the given parts, mm. */
  maxDistanceFrom(pieces: LineSegmentTree): number {
    const { places } = this;
    const stride = 3 * Math.ceil(places.length / 3 / MAX_POINTS);
    let farthest = 0;
    for (let i = 0; i < places.length; i += stride) {
      farthest = Math.max(farthest, pieces.distanceTo(places[i], places[i + 1], places[i + 2]));
    }
    return farthest;
  }
}

/**
 * Returns motions at feed; rapids count only by their ends, because machines have their own paths between.
 */
function pathPolyline(walk: PathTraversal): Polyline {
  const line = new Polyline();
  for (const { from_mm, to_mm, rapid, arc } of walk.motions) {
    if (rapid || !from_mm) {
      line.add(to_mm, to_mm);
      continue;
    }
    let at = from_mm;
    for (const next of arc ? sampleArc(arc, CHORD_MM) : [to_mm]) {
      line.add(at, next);
      at = next;
    }
  }
  return line;
}

/**
 * Returns the drawn path of a run: all of it, or its moves at feed from the first contact with the path,
 * because a path does not define the approach.
 */
function runPolyline({ sections }: Segments, cutsFrom: Vector | null): Polyline {
  const line = new Polyline();
  let before: Vector | null = null;
  let hasBegun = cutsFrom === null;
  for (const section of sections) {
    const { vertex_mm, vertices } = section;
    for (let i = 0; i < vertices; ++i) {
      const at: Vector = [vertex_mm[3 * i], vertex_mm[3 * i + 1], vertex_mm[3 * i + 2]];
      const counts = cutsFrom === null || !isRapid(section.vertexFlags(i));
      if (before && hasBegun && counts) line.add(before, at);
      hasBegun ||= distance(at, cutsFrom!) < ON_PATH_MM;
      before = at;
    }
  }
  return line;
}

/** Returns null if one of both has no path. */
export function roundTrip(walk: PathTraversal, segments: Segments): RoundTrip | null {
  const path = pathPolyline(walk);
  const way = runPolyline(segments, null);
  if (path.ends.length === 0 || way.ends.length === 0) return null;
  const cuts = runPolyline(segments, walk.motions[0].to_mm);
  // A run that never reaches the path is compared completely.
  const held = cuts.ends.length > 0 ? cuts : way;
  return { runDeviation_mm: held.maxDistanceFrom(path.toSegmentTree()), pathDeviation_mm: path.maxDistanceFrom(way.toSegmentTree()) };
}

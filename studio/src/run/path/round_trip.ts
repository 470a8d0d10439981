// The round trip of a path: it was written as a program, the program has run, and the way of the run is held against the path.

import { isRapid, type Segments } from "../segments";
import { sampleArc } from "./path_arc";
import type { Walk } from "./path_walk";
import { Pieces } from "./pieces";
import { between, distance, type Vector } from "./vector";

export interface RoundTrip {
  /** How far the way of the run is from the path where it is farthest, mm, and the path from the way of the run. */
  wayOff_mm: number;
  pathOff_mm: number;
}

/** Chords in place of arcs are off them by this at most. */
const CHORD_MM = 1e-4;
/** Long lines are looked at in so many places, too. */
const STEP_MM = 1;
const MOST_STEPS = 32;
/** A run that has come so near to the path's first point is on the path. */
const BEGUN_MM = 0.1;
/** More places than this are looked at here and there only. */
const MOST_PLACES = 400_000;

/** A list of points with the pieces between them. */
class Polyline {
  readonly ends: number[] = [];
  readonly places: number[] = [];

  add(from: Vector, to: Vector): void {
    this.ends.push(...from, ...to);
    const steps = Math.min(Math.ceil(distance(from, to) / STEP_MM), MOST_STEPS);
    for (let i = 0; i < steps; ++i) this.places.push(...between(from, to, i / steps));
    this.places.push(...to);
  }

  pieces(): Pieces {
    return new Pieces(Float64Array.from(this.ends));
  }

  /** The greatest distance of its places from pieces, mm. */
  farthestFrom(pieces: Pieces): number {
    const { places } = this;
    const stride = 3 * Math.ceil(places.length / 3 / MOST_PLACES);
    let farthest = 0;
    for (let i = 0; i < places.length; i += stride) {
      farthest = Math.max(farthest, pieces.distanceTo(places[i], places[i + 1], places[i + 2]));
    }
    return farthest;
  }
}

/** Motions at feed; rapid ones are where they end, for machines have ways of their own between. */
function lineOfPath(walk: Walk): Polyline {
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
 * The drawn way of a run: all of it, or its moves at feed from where it first comes to the path: how the machine gets
 * there no path says.
 */
function lineOfRun({ stretches }: Segments, cutsFrom: Vector | null): Polyline {
  const line = new Polyline();
  let before: Vector | null = null;
  let hasBegun = cutsFrom === null;
  for (const stretch of stretches) {
    const { vertex_mm, vertices } = stretch;
    for (let i = 0; i < vertices; ++i) {
      const at: Vector = [vertex_mm[3 * i], vertex_mm[3 * i + 1], vertex_mm[3 * i + 2]];
      const counts = cutsFrom === null || !isRapid(stretch.flagsOf(i));
      if (before && hasBegun && counts) line.add(before, at);
      hasBegun ||= distance(at, cutsFrom!) < BEGUN_MM;
      before = at;
    }
  }
  return line;
}

/** null: one of both has no way. */
export function roundTrip(walk: Walk, segments: Segments): RoundTrip | null {
  const path = lineOfPath(walk);
  const way = lineOfRun(segments, null);
  if (path.ends.length === 0 || way.ends.length === 0) return null;
  const cuts = lineOfRun(segments, walk.motions[0].to_mm);
  // A run that never comes to the path is as far off as it is.
  const held = cuts.ends.length > 0 ? cuts : way;
  return { wayOff_mm: held.farthestFrom(path.pieces()), pathOff_mm: path.farthestFrom(way.pieces()) };
}

// Arcs of a path: through a via point, or about a centre; including helices and several turns.

import { texts } from "../../texts";
import type { Point } from "./path_file";
import { add, cross, distance, dot, vectorLength, scaled, subtract, turned, unit, type Vector } from "./vector";

export interface Arc {
  center: Vector;
  /** From the centre to the start. */
  first: Vector;
  normal: Vector;
  endRadius_mm: number;
  turn_rad: number;
  /** Distance along the normal, from the start to the end. */
  rise_mm: number;
}

const MIN_LENGTH_MM = 1e-6;
/** Max distance of the ends of an arc from its circle. */
const TOLERANCE_MM = 0.01;
const FULL_TURN_rad = 2 * Math.PI;
const DEG_PER_RAD = 180 / Math.PI;
const words = texts.paths.errors;

/** Returns the angle from one radius to another about the normal, from 0 to a full turn. */
function angleBetween(from: Vector, to: Vector, normal: Vector): number {
  const angle = Math.atan2(dot(normal, cross(from, to)), dot(from, to));
  return angle < 0 ? angle + FULL_TURN_rad : angle;
}

function arcThrough(start: Vector, via: Vector, end: Vector): Arc | string {
  const chord = subtract(end, start);
  const toVia = subtract(via, start);
  if (vectorLength(chord) < MIN_LENGTH_MM) return words.viaNoWay;
  const across = cross(chord, toVia);
  if (vectorLength(across) < MIN_LENGTH_MM * vectorLength(chord)) return words.viaOnLine;
  const sum = add(scaled(cross(across, chord), dot(toVia, toVia)), scaled(cross(toVia, across), dot(chord, chord)));
  const toCenter = scaled(sum, 1 / (2 * dot(across, across)));
  const center = add(start, toCenter);
  const first = scaled(toCenter, -1);
  const normal = scaled(across, -1 / vectorLength(across));
  const turn_rad = angleBetween(first, subtract(end, center), normal);
  return { center, first, normal, endRadius_mm: vectorLength(first), turn_rad, rise_mm: 0 };
}

/** The remainder nearest to 0. */
const wrapped = (angle: number): number => angle - FULL_TURN_rad * Math.round(angle / FULL_TURN_rad);

function about(start: Vector, { center_mm, normal, turn_deg }: Point, end: Vector): Arc | string {
  const axis = unit(normal ?? [0, 0, 1]) ?? [0, 0, 1];
  const given = center_mm!;
  const center = add(given, scaled(axis, dot(axis, subtract(start, given))));
  const first = subtract(start, center);
  const rise_mm = dot(axis, subtract(end, center));
  const last = subtract(subtract(end, center), scaled(axis, rise_mm));
  const [radius_mm, endRadius_mm] = [vectorLength(first), vectorLength(last)];
  if (radius_mm < MIN_LENGTH_MM) return words.startsAtCenter;
  if (Math.abs(endRadius_mm - radius_mm) > TOLERANCE_MM) return words.radiiDiffer(radius_mm.toPrecision(6), endRadius_mm.toPrecision(6));
  const turn_rad = turn_deg! / DEG_PER_RAD;
  const off = wrapped(turn_rad - angleBetween(first, last, axis));
  if (Math.abs(off) * radius_mm > TOLERANCE_MM) {
    const right = (turn_rad - off) * DEG_PER_RAD;
    return words.turnLeadsElsewhere(turn_deg!, (right > 0 ? right : right + 360).toPrecision(6));
  }
  return { center, first, normal: axis, endRadius_mm, turn_rad: Math.max(turn_rad - off, Math.abs(off)), rise_mm };
}

/** Returns the arc from a start to a circular point, or a message if none exists. */
export function arcTo(start: Vector, point: Point): Arc | string {
  return point.via_mm ? arcThrough(start, point.via_mm, point.position_mm) : about(start, point, point.position_mm);
}

/** Returns a point of an arc, at a share from 0 to 1 of its length. */
export function arcPoint({ center, first, normal, endRadius_mm, turn_rad, rise_mm }: Arc, share: number): Vector {
  const scale = 1 + share * (endRadius_mm / vectorLength(first) - 1);
  return add(add(center, scaled(turned(first, normal, share * turn_rad), scale)), scaled(normal, share * rise_mm));
}

export const arcLength_mm = ({ first, turn_rad, rise_mm }: Arc): number => Math.hypot(vectorLength(first) * turn_rad, rise_mm);

/** Returns the direction at a share of its length, a vector of length 1. */
export function arcDirection(arc: Arc, share: number): Vector {
  const around = scaled(turned(cross(arc.normal, arc.first), arc.normal, share * arc.turn_rad), arc.turn_rad);
  return unit(add(around, scaled(arc.normal, arc.rise_mm)))!;
}

/**
 * Returns points of an arc, without its start, so that the chords between them deviate by no more than this.
 */
export function sampleArc(arc: Arc, deviation_mm: number, most = 20_000): Vector[] {
  const radius_mm = Math.max(vectorLength(arc.first), arc.endRadius_mm);
  const step_rad = 2 * Math.acos(Math.max(1 - deviation_mm / radius_mm, 0.5));
  const count = Math.min(Math.max(Math.ceil(arc.turn_rad / step_rad), 2), most);
  return Array.from({ length: count }, (_, i) => arcPoint(arc, (i + 1) / count));
}

/** True if a via point can define it: less than a full turn in one plane. */
export const isPlainArc = (arc: Arc, start: Vector, end: Vector): boolean =>
  arc.turn_rad < FULL_TURN_rad && Math.abs(arc.rise_mm) < MIN_LENGTH_MM && distance(start, end) > MIN_LENGTH_MM;

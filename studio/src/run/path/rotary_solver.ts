// Rotary axis values for a tool direction: found step by step from the current ones, by the machine's own
// chain.

import { Vector3 } from "three";
import type { Chain } from "../chain";
import { toolDirection } from "./tool_direction";

const MAX_ITERATIONS = 40;
const DIFFERENTIATION_STEP_DEG = 1e-4;
/** Chord below which two directions are the same. */
const DIRECTION_TOLERANCE = 1e-9;
/** Other starts, for poses at which small steps of the axes give no direction to search in. */
const START_VALUES_DEG = [0, 45, -45, 90, -90, 135, -135, 180];

type Values = Record<string, number>;

/** Solves (J'J + damping) x = J'r for a few unknowns. */
function solve(columns: Vector3[], rest: Vector3, damping: number): number[] {
  const n = columns.length;
  const rows = columns.map((a, i) => [...columns.map((b, j) => a.dot(b) + (i === j ? damping : 0)), a.dot(rest)]);
  for (let i = 0; i < n; ++i) {
    for (let k = 0; k < n; ++k) {
      if (k === i) continue;
      const factor = rows[k][i] / rows[i][i];
      for (let j = i; j <= n; ++j) rows[k][j] -= factor * rows[i][j];
    }
  }
  return rows.map((row, i) => row[n] / row[i]);
}

function solveFrom(targetAxis: Vector3, start: Values, chain: Chain): Values | null {
  const letters = Object.keys(start);
  let [values, damping] = [start, 1e-8];
  let at = toolDirection({ rotary_deg: values }, chain)!;
  for (let step = 0; step < MAX_ITERATIONS; ++step) {
    const rest = targetAxis.clone().sub(at);
    if (rest.length() < DIRECTION_TOLERANCE) return values;
    const columns = letters.map((letter) => {
      const moved = toolDirection({ rotary_deg: { ...values, [letter]: values[letter] + DIFFERENTIATION_STEP_DEG } }, chain)!;
      return moved.sub(at).divideScalar(DIFFERENTIATION_STEP_DEG);
    });
    const by = solve(columns, rest, damping);
    const next = Object.fromEntries(letters.map((letter, i) => [letter, values[letter] + by[i]]));
    const nextDirection = toolDirection({ rotary_deg: next }, chain)!;
    // A step that brings no improvement is repeated with a shorter one.
    if (nextDirection.distanceTo(targetAxis) < at.distanceTo(targetAxis)) [values, at, damping] = [next, nextDirection, Math.max(damping / 10, 1e-12)];
    else damping *= 30;
  }
  return null;
}

const totalChange = (from: Values, to: Values): number =>
  Math.max(...Object.keys(from).map((letter) => Math.abs(to[letter] - from[letter])));

/** Returns values in deg by letter, as near to the given ones as possible; null: none found. */
export function solveRotaryAxes(targetAxis: Vector3, near: Values, chain: Chain): Values | null {
  const direction = targetAxis.clone().normalize();
  if (!toolDirection({ rotary_deg: near }, chain) || Object.keys(near).length === 0) return null;
  const [first] = Object.keys(near);
  let best: Values | null = null;
  for (const by of START_VALUES_DEG) {
    const found = solveFrom(direction, { ...near, [first]: near[first] + by }, chain);
    if (found && (!best || totalChange(near, found) < totalChange(near, best))) best = found;
    if (best && totalChange(near, best) < 30) return best;
  }
  return best;
}

// Distance between two bodies, from the points of each that are farthest in a direction (Gilbert, Johnson and
// Keerthi, 1988). A mesh counts as its hull.

import { Matrix3, Matrix4, Vector3 } from "three";
import type { Shape } from "./scene";

/** Body without the margin around it. */
interface Core {
  /** Returns its farthest point in a direction, in the world. */
  support(direction: Vector3): Vector3;
  margin_mm: number;
}

const MAX_ITERATIONS = 100;
/** Smallest improvement that counts, relative to the distance squared. */
const MIN_IMPROVEMENT = 1e-10;

/** Works in the shape's own frame. */
function supportFunction(shape: Shape, meshes: Float32Array[]): (direction: Vector3) => Vector3 {
  switch (shape.kind) {
    case "box": {
      const [x, y, z] = shape.half_mm;
      return (d) => new Vector3(Math.sign(d.x) * x, Math.sign(d.y) * y, Math.sign(d.z) * z);
    }
    case "cylinder":
      return (d) => {
        const across = Math.hypot(d.x, d.y);
        const share = across > 0 ? shape.radius_mm / across : 0;
        return new Vector3(d.x * share, d.y * share, Math.sign(d.z) * shape.half_height_mm);
      };
    case "points":
      return (d) => supportPoint(shape.points_mm.flat(), d);
    case "mesh":
      return (d) => supportPoint(meshes[shape.mesh] ?? [], d);
  }
}

function supportPoint(coordinates: ArrayLike<number>, d: Vector3): Vector3 {
  let [best, most] = [0, -Infinity];
  for (let i = 0; i < coordinates.length; i += 3) {
    const along = coordinates[i] * d.x + coordinates[i + 1] * d.y + coordinates[i + 2] * d.z;
    if (along > most) [best, most] = [i, along];
  }
  return new Vector3(coordinates[best], coordinates[best + 1], coordinates[best + 2]);
}

/** Returns a body of a scene at its pose. */
export function createCore(shape: Shape, meshes: Float32Array[], place: Matrix4): Core {
  const support = supportFunction(shape, meshes);
  const back = new Matrix3().setFromMatrix4(place).transpose();
  return {
    support: (direction) => support(direction.clone().applyMatrix3(back)).applyMatrix4(place),
    margin_mm: shape.kind === "mesh" ? 0 : shape.margin_mm,
  };
}

/**
 * Returns the weights of the combination of points that is nearest to the origin; null: it has a weight below
 * 0.
 */
function barycentricWeights(points: Vector3[]): number[] | null {
  const [first, ...others] = points;
  if (others.length === 0) return [1];
  const offsets = others.map((point) => point.clone().sub(first));
  // Solves the normal equations by elimination: three at most.
  const rows = offsets.map((offset) => [...offsets.map((other) => offset.dot(other)), -offset.dot(first)]);
  for (let i = 0; i < rows.length; ++i) {
    const pivot = rows[i][i];
    if (Math.abs(pivot) < 1e-12) return null;
    for (let j = 0; j < rows.length; ++j) {
      if (j === i) continue;
      const factor = rows[j][i] / pivot;
      for (let k = i; k < rows[j].length; ++k) rows[j][k] -= factor * rows[i][k];
    }
  }
  const shares = rows.map((row, i) => row[row.length - 1] / row[i]);
  const all = [1 - shares.reduce((sum, share) => sum + share, 0), ...shares];
  return all.every((share) => share >= 0) ? all : null;
}

const weightedSum = (points: Vector3[], shares: number[]): Vector3 =>
  points.reduce((sum, point, i) => sum.addScaledVector(point, shares[i]), new Vector3());

/** Returns the point of a simplex that is nearest to the origin, and the corners that it combines. */
function nearest(simplex: Vector3[]): { point: Vector3; corners: Vector3[] } {
  let best = { point: simplex[0], corners: [simplex[0]] };
  for (let set = 1; set < 1 << simplex.length; ++set) {
    const corners = simplex.filter((_, i) => set & (1 << i));
    const shares = barycentricWeights(corners);
    const point = shares && weightedSum(corners, shares);
    if (point && point.lengthSq() < best.point.lengthSq()) best = { point, corners };
  }
  return best;
}

/** In mm; 0: they touch. */
export function distanceBetween(a: Core, b: Core): number {
  const support = (direction: Vector3) => a.support(direction).sub(b.support(direction.clone().negate()));
  let point = support(new Vector3(1, 0, 0));
  let simplex = [point];
  for (let i = 0; i < MAX_ITERATIONS; ++i) {
    const square = point.lengthSq();
    if (square < MIN_IMPROVEMENT) return 0;
    const next = support(point.clone().negate());
    if (square - point.dot(next) <= MIN_IMPROVEMENT * square) break;
    const { point: nearer, corners } = nearest([...simplex, next]);
    if (nearer.lengthSq() >= square) break;
    [point, simplex] = [nearer, corners];
  }
  return Math.max(0, point.length() - a.margin_mm - b.margin_mm);
}

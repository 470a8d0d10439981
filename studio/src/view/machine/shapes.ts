// Shapes of bodies as surfaces (mm).

import {
  BoxGeometry,
  BufferAttribute,
  BufferGeometry,
  CapsuleGeometry,
  CylinderGeometry,
  Quaternion,
  SphereGeometry,
  Vector3,
} from "three";
import { ConvexGeometry } from "three/examples/jsm/geometries/ConvexGeometry.js";
import type { Point, Shape } from "../../run/scene";

const RADIAL_SEGMENTS = 32;

/** Returns a cylinder along Z, as in the engine. */
export const cylinder = (radius_mm: number, height_mm: number, top_mm = radius_mm): CylinderGeometry => {
  const geometry = new CylinderGeometry(top_mm, radius_mm, height_mm, RADIAL_SEGMENTS);
  geometry.rotateX(Math.PI / 2);
  return geometry;
};

function capsule(a: Vector3, b: Vector3, radius_mm: number): BufferGeometry {
  const way = b.clone().sub(a);
  const geometry = new CapsuleGeometry(radius_mm, way.length(), 8, RADIAL_SEGMENTS);
  geometry.applyQuaternion(new Quaternion().setFromUnitVectors(new Vector3(0, 1, 0), way.normalize()));
  const middle = a.clone().add(b).multiplyScalar(0.5);
  return geometry.translate(middle.x, middle.y, middle.z);
}

/** Returns the hull of spheres of one radius about points; spheres of few corners are near enough. */
function hull(points: Vector3[], margin_mm: number): BufferGeometry {
  if (margin_mm <= 0) return points.length > 3 ? new ConvexGeometry(points) : new BufferGeometry().setFromPoints(points);
  const ball = new SphereGeometry(margin_mm, 12, 8).getAttribute("position");
  const corners = points.flatMap((point) =>
    Array.from({ length: ball.count }, (_, i) => new Vector3().fromBufferAttribute(ball, i).add(point)),
  );
  return new ConvexGeometry(corners);
}

function pointsGeometry(all: Point[], margin_mm: number): BufferGeometry {
  const points = all.map((point) => new Vector3(...point));
  if (points.length === 1) {
    return new SphereGeometry(Math.max(margin_mm, 0.1), RADIAL_SEGMENTS, RADIAL_SEGMENTS / 2).translate(
      points[0].x,
      points[0].y,
      points[0].z,
    );
  }
  if (points.length === 2) return capsule(points[0], points[1], Math.max(margin_mm, 0.1));
  return hull(points, margin_mm);
}

export function createGeometry(shape: Shape, meshes: Float32Array[]): BufferGeometry {
  switch (shape.kind) {
    case "box": {
      const [x, y, z] = shape.half_mm.map((half) => 2 * (half + shape.margin_mm));
      return new BoxGeometry(x, y, z);
    }
    case "cylinder":
      return cylinder(shape.radius_mm + shape.margin_mm, 2 * (shape.half_height_mm + shape.margin_mm));
    case "points":
      return pointsGeometry(shape.points_mm, shape.margin_mm);
    case "mesh": {
      const geometry = new BufferGeometry();
      geometry.setAttribute("position", new BufferAttribute(meshes[shape.mesh] ?? new Float32Array(), 3));
      geometry.computeVertexNormals();
      return geometry;
    }
  }
}

// Finds the path, the machine or the work plane at a position on the screen.

import { type Intersection, Matrix4, type Object3D, Plane, Raycaster, Vector2, Vector3 } from "three";
import type { CameraRig } from "./camera";
import type { Machine } from "./machine/machine";
import type { PathData } from "./path/path_data";
import type { Hit } from "./path/path_layer";
import type { RunScene } from "./run_scene";

const SNAP_PX = 8;
const BISECTION_STEPS = 24;

/** Returns the position along a part, 0 to 1. */
export function segmentShare(a: Vector3, b: Vector3, place: Vector3): number {
  const way = b.clone().sub(a);
  const square = way.lengthSq();
  return square > 0 ? Math.min(Math.max(place.clone().sub(a).dot(way) / square, 0), 1) : 0;
}

/** Returns the part that ends at a vertex, and the position of a hit along it. */
export function hitSegment(data: PathData, { vertex, t_s }: Hit): { a: Vector3; b: Vector3; share: number } {
  const from_s = data.time_s(vertex - 1);
  const to_s = data.time_s(vertex);
  const share = to_s > from_s ? Math.min(Math.max((t_s - from_s) / (to_s - from_s), 0), 1) : 1;
  return { a: data.point(vertex - 1), b: data.point(vertex), share };
}

/**
 * Returns the time at which the tool is at a hit: parts are drawn evenly in time, but the tool accelerates
 * and decelerates in them. If its joints are not loaded, returns the drawn time.
 */
export function hitTime(data: PathData, hit: Hit, machine: Machine): number {
  const { a, b, share } = hitSegment(data, hit);
  let [from_s, to_s] = [data.time_s(hit.vertex - 1), data.time_s(hit.vertex)];
  if (a.distanceToSquared(b) === 0) return from_s;
  for (let i = 0; i < BISECTION_STEPS; ++i) {
    const middle_s = (from_s + to_s) / 2;
    const { linkPoses, tip_mm } = machine.at(middle_s);
    if (segmentShare(a, b, tip_mm.applyMatrix4(linkPoses.work.invert())) < share) from_s = middle_s;
    else to_s = middle_s;
  }
  return to_s;
}

/** Returns the ends of a part that are also ends of a segment; the others only make an arc look round. */
function segmentEnds(data: PathData, vertex: number): Vector3[] {
  const segment = data.vertexSegment(vertex);
  const ends: Vector3[] = [];
  if (vertex === 1 || data.vertexSegment(vertex - 1) !== segment) ends.push(data.point(vertex - 1));
  if (vertex + 1 >= data.count || data.vertexSegment(vertex + 1) !== segment) ends.push(data.point(vertex));
  return ends;
}

interface Size {
  width_px: number;
  height_px: number;
}

function rayAt(x_px: number, y_px: number, size: Size, rig: CameraRig): Raycaster {
  const ray = new Raycaster();
  ray.setFromCamera(new Vector2((2 * x_px) / size.width_px - 1, 1 - (2 * y_px) / size.height_px), rig.camera);
  return ray;
}

function isVisible(object: Object3D): boolean {
  return object.visible && (object.parent === null || isVisible(object.parent));
}

/** Returns the first visible body of machines and cells on a ray. */
function firstBody(ray: Raycaster, runScene: RunScene): Intersection | undefined {
  return ray.intersectObject(runScene.machineGroup, true).find(({ object }) => isVisible(object));
}

/** Returns the name of the body at a position; null: no body, or it has no name. */
export function bodyAt(x_px: number, y_px: number, size: Size, runScene: RunScene, rig: CameraRig): string | null {
  return firstBody(rayAt(x_px, y_px, size, rig), runScene)?.object.name || null;
}

/**
 * Returns a position to measure from, in a work frame: on the path (ends of segments attract), on a body, or
 * on the work plane.
 */
export function positionAt(
  x_px: number,
  y_px: number,
  size: Size,
  hit: Hit | null,
  runScene: RunScene,
  rig: CameraRig,
  works: Matrix4[],
  frame: Matrix4,
): Vector3 | null {
  const toFrame = frame.clone().invert();
  if (hit) {
    const { a, b, share } = hitSegment(runScene.paths[hit.robot], hit);
    const work = works[hit.robot];
    const near = segmentEnds(runScene.paths[hit.robot], hit.vertex).find((end) => {
      const projected = rig.project(end.clone().applyMatrix4(work));
      return projected && Math.hypot(projected.x - x_px, projected.y - y_px) < SNAP_PX;
    });
    return (near ?? a.lerp(b, share)).applyMatrix4(work).applyMatrix4(toFrame);
  }
  const ray = rayAt(x_px, y_px, size, rig);
  const body = firstBody(ray, runScene);
  if (body) return body.point.applyMatrix4(toFrame);
  const plane = new Plane(new Vector3(0, 0, 1), 0).applyMatrix4(frame);
  const place = ray.ray.intersectPlane(plane, new Vector3());
  return place && place.applyMatrix4(toFrame);
}

/**
 * Returns the vertex time up to which a path is done: the current drawn part is cut at the position of the
 * tool.
 */
export function lastDoneVertex(data: PathData, t_s: number, tcpInWork: Vector3): number {
  const vertex = data.at(t_s);
  if (vertex <= 0) return -1;
  if (vertex >= data.count) return Infinity;
  const from_s = data.time_s(vertex - 1);
  const share = segmentShare(data.point(vertex - 1), data.point(vertex), tcpInWork);
  return from_s + share * (data.time_s(vertex) - from_s);
}

// Grips of a handle: an arrow moves along its axis, the dot in the middle in a plane, a ring rotates. This
// module has their positions on the screen, and the effect of a drag.

import { Matrix4, Plane, Quaternion, Ray, Raycaster, Vector2, Vector3 } from "three";
import type { CameraRig } from "../camera";

export interface HandleGrip {
  kind: "move" | "plane" | "turn";
  /** Axis of the work frame; for a plane its normal. */
  axis: 0 | 1 | 2;
}

/** Sizes on the screen. */
export const ARROW_PX = 64;
export const RING_PX = 84;
const HIT_DISTANCE_PX = 7;
const RING_STEPS = 64;
/** Distance from the middle within which arrows cannot be distinguished. */
const CENTRE_RADIUS_PX = 9;
/** Sine of the smallest view angle of a plane that can be used for a drag. */
const MIN_SINE = 0.2;

export const unitVector = (axis: number): Vector3 => new Vector3().setComponent(axis, 1);

/** Returns a point of a ring about an axis, of radius 1. */
export function ringPoint(axis: number, angle: number): Vector3 {
  const point = new Vector3();
  point.setComponent((axis + 1) % 3, Math.cos(angle));
  return point.setComponent((axis + 2) % 3, Math.sin(angle));
}

/** Position of a handle in the work frame, and its view. */
export interface HandleContext {
  work: Matrix4;
  at: Vector3;
  rig: CameraRig;
  /** Size of the picture in pixels. */
  width_px: number;
  height_px: number;
}

export const handleScale = ({ work, at, rig }: HandleContext): number => rig.mmPerPixelAt(at.clone().applyMatrix4(work));

const toScreen = ({ work, rig }: HandleContext, point: Vector3): Vector2 | null => {
  const projected = rig.project(point.clone().applyMatrix4(work));
  return projected && new Vector2(projected.x, projected.y);
};

/** Returns the direction towards the camera, in the work frame. */
const viewDirection = ({ work, rig }: HandleContext): Vector3 => rig.basis().back.transformDirection(work.clone().invert());

function distanceToSegment(p: Vector2, a: Vector2, b: Vector2): number {
  const way = b.clone().sub(a);
  const size = way.lengthSq();
  const share = size > 0 ? Math.min(Math.max(p.clone().sub(a).dot(way) / size, 0), 1) : 0;
  return p.distanceTo(way.multiplyScalar(share).add(a));
}

/** Returns the plane of the work with the best view. */
export function mostVisiblePlane(handleContext: HandleContext): 0 | 1 | 2 {
  const [x, y, z] = viewDirection(handleContext).toArray().map(Math.abs);
  // The horizontal plane, unless it is seen edge-on.
  return z > 0.35 ? 2 : x > y ? 0 : 1;
}

/** Returns null if no grip is at that position of the screen. */
export function gripAt(handleContext: HandleContext, x_px: number, y_px: number, turns: boolean): HandleGrip | null {
  const pointer = new Vector2(x_px, y_px);
  const middle = toScreen(handleContext, handleContext.at);
  if (!middle) return null;
  if (pointer.distanceTo(middle) < CENTRE_RADIUS_PX) return { kind: "plane", axis: mostVisiblePlane(handleContext) };
  const scale = handleScale(handleContext);
  let best: { grip: HandleGrip; distance_px: number } | null = null;
  const consider = (grip: HandleGrip, distance_px: number) => {
    if (distance_px < HIT_DISTANCE_PX && distance_px < (best?.distance_px ?? Infinity)) best = { grip, distance_px };
  };
  for (const axis of [0, 1, 2] as const) {
    const end = toScreen(handleContext, handleContext.at.clone().addScaledVector(unitVector(axis), ARROW_PX * scale));
    if (end && end.distanceTo(middle) > CENTRE_RADIUS_PX) consider({ kind: "move", axis }, distanceToSegment(pointer, middle, end));
    if (!turns) continue;
    let before: Vector2 | null = null;
    for (let i = 0; i <= RING_STEPS; ++i) {
      const angle = (2 * Math.PI * i) / RING_STEPS;
      const next = toScreen(handleContext, handleContext.at.clone().addScaledVector(ringPoint(axis, angle), RING_PX * scale));
      if (before && next) consider({ kind: "turn", axis }, distanceToSegment(pointer, before, next));
      before = next;
    }
  }
  return (best as { grip: HandleGrip } | null)?.grip ?? null;
}

/** Returns the ray from the camera through a position of the screen, in the work frame. */
function rayAt({ work, rig, width_px, height_px }: HandleContext, x_px: number, y_px: number): Ray {
  const caster = new Raycaster();
  caster.setFromCamera(new Vector2((2 * x_px) / width_px - 1, 1 - (2 * y_px) / height_px), rig.camera);
  return caster.ray.applyMatrix4(work.clone().invert());
}

/** Returns the position along an axis that is nearest to a ray, mm from `at`. */
function alongAxis(ray: Ray, at: Vector3, axis: Vector3): number | null {
  const between = at.clone().sub(ray.origin);
  const cosine = axis.dot(ray.direction);
  const sine2 = 1 - cosine * cosine;
  if (sine2 < MIN_SINE ** 2 / 4) return null;
  return (cosine * ray.direction.dot(between) - axis.dot(between)) / sine2;
}

/** Drag of a grip: converts the pointer position to a motion of the point. */
export class HandleDrag {
  private readonly begun: number | Vector3 | null;

  constructor(
    private readonly handleContext: HandleContext,
    private readonly grip: HandleGrip,
    private readonly start_px: Vector2,
  ) {
    this.begun = this.measure(start_px.x, start_px.y);
  }

  /** Measures along the axis, in the plane, or the angle about the axis. */
  private measure(x_px: number, y_px: number): number | Vector3 | null {
    const { handleContext, grip } = this;
    const axis = unitVector(grip.axis);
    const ray = rayAt(handleContext, x_px, y_px);
    if (grip.kind === "move") return alongAxis(ray, handleContext.at, axis);
    const plane = new Plane().setFromNormalAndCoplanarPoint(axis, handleContext.at);
    const place = Math.abs(axis.dot(ray.direction)) > MIN_SINE ? ray.intersectPlane(plane, new Vector3()) : null;
    if (grip.kind === "plane") return place;
    if (!place) return null;
    const off = place.sub(handleContext.at);
    return Math.atan2(off.getComponent((grip.axis + 2) % 3), off.getComponent((grip.axis + 1) % 3));
  }

  /** Returns the motion of the point for a drag to a position, mm, in full steps. */
  shift(x_px: number, y_px: number): Vector3 {
    const now = this.measure(x_px, y_px);
    const { begun, grip } = this;
    const shift = new Vector3();
    if (typeof now === "number" && typeof begun === "number") shift.setComponent(grip.axis, now - begun);
    else if (now instanceof Vector3 && begun instanceof Vector3) shift.copy(now).sub(begun);
    const step = 10 ** Math.floor(Math.log10(handleScale(this.handleContext)));
    return new Vector3(...shift.toArray().map((mm) => Math.round(mm / step) * step));
  }

  /** Returns the rotation of the tool for a drag to a position. */
  turn(x_px: number, y_px: number): Quaternion {
    const now = this.measure(x_px, y_px);
    const isOnRing = typeof now === "number" && typeof this.begun === "number";
    const angle = isOnRing ? now - (this.begun as number) : this.angleByTangent(x_px, y_px);
    const rounded = Math.round((angle * 180) / Math.PI) * (Math.PI / 180);
    return new Quaternion().setFromAxisAngle(unitVector(this.grip.axis), rounded);
  }

  /** Measures a ring that is seen edge-on along its tangent. */
  private angleByTangent(x_px: number, y_px: number): number {
    const away = viewDirection(this.handleContext).cross(unitVector(this.grip.axis)).negate();
    const [from, to] = [this.handleContext.at, this.handleContext.at.clone().addScaledVector(away, handleScale(this.handleContext))];
    const [a, b] = [toScreen(this.handleContext, from), toScreen(this.handleContext, to)];
    if (!a || !b) return 0;
    return new Vector2(x_px, y_px).sub(this.start_px).dot(b.sub(a).normalize()) / RING_PX;
  }
}

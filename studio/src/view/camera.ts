// Camera: it orbits a target on a sphere; Z of the world is up on the screen.

import { Box3, Matrix4, OrthographicCamera, PerspectiveCamera, Vector3 } from "three";

export type StandardView = "top" | "front" | "side" | "iso";

const FOV_DEG = 35;
const HALF_FOV = (FOV_DEG / 2) * (Math.PI / 180);
const RIGHT_ANGLE = Math.PI / 2;

const stands: Record<StandardView, [azimuth: number, elevation: number]> = {
  top: [-RIGHT_ANGLE, RIGHT_ANGLE],
  front: [-RIGHT_ANGLE, 0],
  side: [0, 0],
  iso: [-0.3 * Math.PI, 0.2 * Math.PI],
};

const NEAREST_MM = 0.05;
const FARTHEST_MM = 1e6;

export class CameraRig {
  readonly target = new Vector3();
  perspective = true;
  private azimuth = stands.iso[0];
  private elevation = stands.iso[1];
  private distance_mm = 1000;
  private width_px = 1;
  private height_px = 1;
  private readonly near = new PerspectiveCamera(FOV_DEG);
  private readonly flat = new OrthographicCamera();
  /** All that may be seen. */
  private readonly world = new Box3(new Vector3(-1000, -1000, -1000), new Vector3(1000, 1000, 1000));

  get camera(): PerspectiveCamera | OrthographicCamera {
    return this.perspective ? this.near : this.flat;
  }

  /** Returns the axes towards the camera, to the right and upwards on the screen. */
  basis(): { back: Vector3; right: Vector3; up: Vector3 } {
    const [ca, sa] = [Math.cos(this.azimuth), Math.sin(this.azimuth)];
    const [ce, se] = [Math.cos(this.elevation), Math.sin(this.elevation)];
    const back = new Vector3(ce * ca, ce * sa, se);
    const right = new Vector3(-sa, ca, 0);
    return { back, right, up: back.clone().cross(right) };
  }

  get mmPerPixel(): number {
    return (2 * this.distance_mm * Math.tan(HALF_FOV)) / this.height_px;
  }

  /** Returns the size of a pixel at a position, mm. */
  mmPerPixelAt(place: Vector3): number {
    if (!this.perspective) return this.mmPerPixel;
    const depth = this.distance_mm - place.clone().sub(this.target).dot(this.basis().back);
    return (2 * Math.max(depth, 1e-3) * Math.tan(HALF_FOV)) / this.height_px;
  }

  resize(width_px: number, height_px: number): void {
    this.width_px = Math.max(width_px, 1);
    this.height_px = Math.max(height_px, 1);
  }

  setVisibleBounds(world: Box3): void {
    if (!world.isEmpty()) this.world.copy(world);
  }

  apply(): void {
    const { back, right, up } = this.basis();
    const { camera } = this;
    camera.position.copy(this.target).addScaledVector(back, this.distance_mm);
    camera.quaternion.setFromRotationMatrix(new Matrix4().makeBasis(right, up, back));
    const radius = this.world.getSize(new Vector3()).length() / 2;
    const away = camera.position.distanceTo(this.world.getCenter(new Vector3()));
    const aspect = this.width_px / this.height_px;
    this.near.aspect = aspect;
    this.near.near = Math.max(away - radius, 0.02 * this.distance_mm);
    this.near.far = Math.max(away + radius, 2 * this.distance_mm);
    const half = this.distance_mm * Math.tan(HALF_FOV);
    Object.assign(this.flat, { left: -half * aspect, right: half * aspect, top: half, bottom: -half });
    Object.assign(this.flat, { near: away - radius - this.distance_mm, far: away + radius + this.distance_mm });
    camera.updateProjectionMatrix();
    camera.updateMatrixWorld();
  }

  /** Copies direction and distance of another camera, with a target shifted by `offset`. */
  copyFrom(other: CameraRig, offset: Vector3): void {
    this.target.copy(other.target).add(offset);
    this.azimuth = other.azimuth;
    this.elevation = other.elevation;
    this.distance_mm = other.distance_mm;
  }

  /** By pixels on the screen. */
  orbit(dx_px: number, dy_px: number): void {
    this.azimuth -= dx_px * 0.007;
    this.elevation = Math.min(Math.max(this.elevation + dy_px * 0.007, -RIGHT_ANGLE), RIGHT_ANGLE);
  }

  pan(dx_px: number, dy_px: number): void {
    const { right, up } = this.basis();
    const scale = this.mmPerPixel;
    this.target.addScaledVector(right, -dx_px * scale).addScaledVector(up, dy_px * scale);
  }

  /**
   * Zooms, nearer for a factor below 1; the point under the position on the screen (px from the middle) stays
   * there.
   */
  zoom(factor: number, x_px = 0, y_px = 0): void {
    const to = Math.min(Math.max(this.distance_mm * factor, NEAREST_MM), FARTHEST_MM);
    const share = 1 - to / this.distance_mm;
    const { right, up } = this.basis();
    const scale = this.mmPerPixel * share;
    this.target.addScaledVector(right, x_px * scale).addScaledVector(up, -y_px * scale);
    this.distance_mm = to;
  }

  setStandardView(name: StandardView): void {
    [this.azimuth, this.elevation] = stands[name];
  }

  /** Targets the middle of a box, so that it just fits on the screen. */
  fit(box: Box3): void {
    if (box.isEmpty()) return;
    box.getCenter(this.target);
    const { back, right, up } = this.basis();
    const aspect = this.width_px / this.height_px;
    const slope = Math.tan(HALF_FOV);
    let distance = 1;
    for (let i = 0; i < 8; ++i) {
      const corner = new Vector3(
        i & 1 ? box.max.x : box.min.x,
        i & 2 ? box.max.y : box.min.y,
        i & 4 ? box.max.z : box.min.z,
      ).sub(this.target);
      const depth = this.perspective ? corner.dot(back) : 0;
      const [x, y] = [Math.abs(corner.dot(right)) / aspect, Math.abs(corner.dot(up))];
      distance = Math.max(distance, depth + Math.max(x, y) / slope);
    }
    this.distance_mm = 1.15 * distance;
  }

  /** Returns pixels from the left and from above; null: not in front of the camera. */
  project(place: Vector3): { x: number; y: number } | null {
    const at = place.clone().applyMatrix4(this.camera.matrixWorldInverse);
    if (this.perspective && at.z > -this.near.near) return null;
    at.applyMatrix4(this.camera.projectionMatrix);
    return { x: ((at.x + 1) / 2) * this.width_px, y: ((1 - at.y) / 2) * this.height_px };
  }
}

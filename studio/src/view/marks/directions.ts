// Arrows on the path, at legible distances on the screen.

import { BufferAttribute, BufferGeometry, DoubleSide, Group, Mesh, MeshBasicMaterial, Vector3, type Matrix4 } from "three";
import { lastIndex } from "../../run/search";
import type { CameraRig } from "../camera";
import type { PathData } from "../path/path_data";
import type { Palette } from "../theme";

const ARROW_SPACING_PX = 80;
const LENGTH_PX = 9;
const MAX_ATTEMPTS = 3000;
const MAX_ARROWS = 250;

interface Screen {
  width_px: number;
  height_px: number;
}

/** Distances along a path at every so many vertices, mm, because ten million could not all be kept. */
class PathDistances {
  private static readonly STEP = 64;
  private readonly distances: Float64Array;
  readonly total: number;

  constructor(private readonly data: PathData) {
    this.distances = new Float64Array(Math.ceil(data.count / PathDistances.STEP));
    let way = 0;
    let [x, y, z] = [NaN, NaN, NaN];
    for (const { section, vertex } of data.vertices(0, data.count)) {
      const { vertex_mm, vertices } = section;
      for (let i = 0; i < vertices; ++i) {
        const [x1, y1, z1] = [vertex_mm[3 * i], vertex_mm[3 * i + 1], vertex_mm[3 * i + 2]];
        if (vertex + i > 0) way += Math.sqrt((x1 - x) ** 2 + (y1 - y) ** 2 + (z1 - z) ** 2);
        if ((vertex + i) % PathDistances.STEP === 0) this.distances[(vertex + i) / PathDistances.STEP] = way;
        [x, y, z] = [x1, y1, z1];
      }
    }
    this.total = way;
  }

  /**
   * Returns the vertex that ends the part at a distance along the path, and the position along that part, 0
   * to 1.
   */
  at(way: number): [vertex: number, share: number] {
    const { data } = this;
    const known = Math.max(lastIndex(this.distances.length, (i) => this.distances[i] <= way), 0);
    let vertex = known * PathDistances.STEP;
    let left = way - this.distances[known];
    const [a, b] = [data.point(vertex), new Vector3()];
    while (++vertex < data.count) {
      const step = a.distanceTo(data.point(vertex, b));
      if (left < step) return [vertex, left / step];
      left -= step;
      a.copy(b);
    }
    return [data.count - 1, 1];
  }
}

export class Directions {
  readonly group = new Group();
  private readonly material = new MeshBasicMaterial({ side: DoubleSide });
  private meshes: Mesh[] = [];
  private readonly distances = new Map<PathData, [number, PathDistances]>();

  setContent(all: PathData[]): void {
    for (const mesh of this.meshes) mesh.geometry.dispose();
    this.group.clear();
    this.distances.clear();
    this.meshes = all.map(() => {
      const mesh = new Mesh(new BufferGeometry(), this.material);
      mesh.matrixAutoUpdate = false;
      mesh.frustumCulled = false;
      mesh.raycast = () => {};
      this.group.add(mesh);
      return mesh;
    });
  }

  place(frames: Matrix4[]): void {
    this.meshes.forEach((mesh, i) => mesh.matrix.copy(frames[i]));
  }

  recolour(colours: Palette): void {
    this.material.color.copy(colours.marks);
  }

  /** Updates the arrows for the current view. */
  layOut(all: PathData[], frames: Matrix4[], rig: CameraRig, screen: Screen, rapids: boolean): void {
    const taken = new Set<number>();
    all.forEach((data, i) => {
      const corners: number[] = [];
      if (data.count > 1) this.placeArrows(data, frames[i], rig, screen, rapids, taken, corners);
      const { geometry } = this.meshes[i];
      geometry.dispose();
      this.meshes[i].geometry = new BufferGeometry();
      this.meshes[i].geometry.setAttribute("position", new BufferAttribute(new Float32Array(corners), 3));
    });
  }

  private placeArrows(
    data: PathData,
    frame: Matrix4,
    rig: CameraRig,
    screen: Screen,
    rapids: boolean,
    taken: Set<number>,
    corners: number[],
  ): void {
    const known = this.distances.get(data);
    const distances = known?.[0] === data.count ? known[1] : new PathDistances(data);
    this.distances.set(data, [data.count, distances]);
    const { total } = distances;
    const space = Math.max(ARROW_SPACING_PX * rig.mmPerPixel, total / MAX_ATTEMPTS);
    const [a, b, world] = [new Vector3(), new Vector3(), new Vector3()];
    const { back } = rig.basis();
    for (let way = space / 2; way < total && taken.size < MAX_ARROWS; way += space) {
      const [vertex, share] = distances.at(way);
      if (!rapids && data.isRapid(vertex)) continue;
      data.point(vertex - 1, a);
      data.point(vertex, b);
      const along = b.clone().sub(a).normalize();
      world.lerpVectors(a, b, share).applyMatrix4(frame);
      const projected = rig.project(world);
      if (!projected || projected.x < 0 || projected.y < 0 || projected.x > screen.width_px || projected.y > screen.height_px) continue;
      const cell = Math.floor(projected.x / 40) + 1000 * Math.floor(projected.y / 40);
      if (taken.has(cell)) continue;
      taken.add(cell);
      addArrow(corners, a.lerp(b, share), along, LENGTH_PX * rig.mmPerPixelAt(world), back);
    }
  }
}

/** Adds a pyramid with its middle at a position. */
export function addArrow(corners: number[], at: Vector3, along: Vector3, length_mm: number, back: Vector3): void {
  const side = Math.abs(along.dot(back)) < 0.98 ? along.clone().cross(back) : along.clone().cross(new Vector3(1, 0.3, 0.2));
  side.setLength(0.32 * length_mm);
  const other = along.clone().cross(side).setLength(0.32 * length_mm);
  const tip = at.clone().addScaledVector(along, 0.5 * length_mm);
  const base = at.clone().addScaledVector(along, -0.5 * length_mm);
  const ring = [side, other, side.clone().negate(), other.clone().negate()].map((way) => way.add(base));
  for (let i = 0; i < 4; ++i) {
    for (const corner of [tip, ring[i], ring[(i + 1) % 4]]) corners.push(corner.x, corner.y, corner.z);
  }
}

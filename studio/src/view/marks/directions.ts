// Arrows on the way, in spaces that one can read on the screen.

import { BufferAttribute, BufferGeometry, DoubleSide, Group, Mesh, MeshBasicMaterial, Vector3, type Matrix4 } from "three";
import { lastIndex } from "../../run/search";
import type { CameraRig } from "../camera";
import type { PathData } from "../path/path_data";
import type { Palette } from "../theme";

const SPACE_PX = 80;
const LENGTH_PX = 9;
const MOST_TRIED = 3000;
const MOST = 250;

interface Screen {
  width_px: number;
  height_px: number;
}

/** Ways along a path up to each vertex, mm. */
function waysOf(data: PathData): Float64Array {
  const ways = new Float64Array(data.count);
  let at = 0;
  let [x, y, z] = [NaN, NaN, NaN];
  for (const { vertex_mm, vertex_s } of data.segments.chunks) {
    for (let i = 0; i < vertex_s.length; ++i, ++at) {
      const [x1, y1, z1] = [vertex_mm[3 * i], vertex_mm[3 * i + 1], vertex_mm[3 * i + 2]];
      const step = Math.sqrt((x1 - x) ** 2 + (y1 - y) ** 2 + (z1 - z) ** 2);
      ways[at] = at === 0 ? 0 : ways[at - 1] + step;
      [x, y, z] = [x1, y1, z1];
    }
  }
  return ways;
}

const firstBeyond = (ways: Float64Array, way: number): number =>
  Math.min(lastIndex(ways.length, (i) => ways[i] <= way) + 1, ways.length - 1);

export class Directions {
  readonly group = new Group();
  private readonly material = new MeshBasicMaterial({ side: DoubleSide });
  private meshes: Mesh[] = [];
  private readonly ways = new Map<PathData, Float64Array>();

  take(all: PathData[]): void {
    for (const mesh of this.meshes) mesh.geometry.dispose();
    this.group.clear();
    this.ways.clear();
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

  /** Lays them anew for what the eye sees. */
  lay(all: PathData[], frames: Matrix4[], rig: CameraRig, screen: Screen, rapids: boolean): void {
    const taken = new Set<number>();
    all.forEach((data, i) => {
      const corners: number[] = [];
      if (data.count > 1) this.layOne(data, frames[i], rig, screen, rapids, taken, corners);
      const { geometry } = this.meshes[i];
      geometry.dispose();
      this.meshes[i].geometry = new BufferGeometry();
      this.meshes[i].geometry.setAttribute("position", new BufferAttribute(new Float32Array(corners), 3));
    });
  }

  private layOne(
    data: PathData,
    frame: Matrix4,
    rig: CameraRig,
    screen: Screen,
    rapids: boolean,
    taken: Set<number>,
    corners: number[],
  ): void {
    const ways = this.ways.get(data) ?? waysOf(data);
    this.ways.set(data, ways);
    const total = ways[ways.length - 1];
    const space = Math.max(SPACE_PX * rig.mmPerPixel, total / MOST_TRIED);
    const [a, b, world] = [new Vector3(), new Vector3(), new Vector3()];
    const { back } = rig.basis();
    for (let way = space / 2; way < total && taken.size < MOST; way += space) {
      const vertex = firstBeyond(ways, way);
      if (!rapids && data.isRapid(vertex)) continue;
      data.point(vertex - 1, a);
      data.point(vertex, b);
      const share = (way - ways[vertex - 1]) / (ways[vertex] - ways[vertex - 1]);
      const along = b.clone().sub(a).normalize();
      world.lerpVectors(a, b, share).applyMatrix4(frame);
      const seen = rig.project(world);
      if (!seen || seen.x < 0 || seen.y < 0 || seen.x > screen.width_px || seen.y > screen.height_px) continue;
      const cell = Math.floor(seen.x / 40) + 1000 * Math.floor(seen.y / 40);
      if (taken.has(cell)) continue;
      taken.add(cell);
      putArrow(corners, a.lerp(b, share), along, LENGTH_PX * rig.mmPerPixelAt(world), back);
    }
  }
}

/** A pyramid with its middle on a place. */
function putArrow(corners: number[], at: Vector3, along: Vector3, length_mm: number, back: Vector3): void {
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

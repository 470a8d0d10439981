// Parts of a machine that is drawn from its joints: each is placed at its pose with all joints at 0, and
// moves with a link from there.

import { BoxGeometry, EdgesGeometry, Group, LineSegments, Matrix4, Mesh, Quaternion, Vector3, type BufferGeometry } from "three";
import type { LinkPoses } from "../../run/chain";
import type { BodyMaterials, Role } from "./body_materials";
import { cylinder } from "./shapes";

interface Part {
  link: number;
  mesh: Mesh;
  inLink: Matrix4;
}

const UP = new Vector3(0, 0, 1);

export class Parts {
  readonly group = new Group();
  private readonly parts: Part[] = [];

  constructor(
    /** Poses with all joints at 0. */
    readonly zero: LinkPoses,
    private readonly bodyMaterials: BodyMaterials,
  ) {}

  private add(link: number, geometry: BufferGeometry, pose: Matrix4, role: Role): void {
    const mesh = new Mesh(geometry, this.bodyMaterials.solid[role]);
    mesh.matrixAutoUpdate = false;
    const edges = new LineSegments(new EdgesGeometry(geometry, 30), this.bodyMaterials.edges);
    edges.matrixAutoUpdate = false;
    edges.raycast = () => {};
    mesh.add(edges);
    this.group.add(mesh);
    this.parts.push({ link, mesh, inLink: this.zero.links[link].clone().invert().multiply(pose) });
  }

  /** Adds a box along two directions and their normal. */
  box(link: number, middle: Vector3, size_mm: [number, number, number], u: Vector3, v: Vector3, role: Role): void {
    const w = u.clone().cross(v);
    const pose = new Matrix4().makeBasis(u, v, w).setPosition(middle);
    this.add(link, new BoxGeometry(...size_mm), pose, role);
  }

  /** Adds a round bar from one position to another. */
  bar(link: number, from: Vector3, to: Vector3, radius_mm: number, role: Role): void {
    const way = to.clone().sub(from);
    const length_mm = way.length();
    if (length_mm < 1e-6) return;
    const turn = new Quaternion().setFromUnitVectors(UP, way.divideScalar(length_mm));
    const pose = new Matrix4().makeRotationFromQuaternion(turn).setPosition(from.clone().add(to).multiplyScalar(0.5));
    this.add(link, cylinder(radius_mm, length_mm), pose, role);
  }

  /** A drum about an axis. */
  drum(link: number, middle: Vector3, axis: Vector3, radius_mm: number, length_mm: number, role: Role): void {
    const half = axis.clone().setLength(length_mm / 2);
    this.bar(link, middle.clone().sub(half), middle.clone().add(half), radius_mm, role);
  }

  place({ links }: LinkPoses): void {
    for (const { link, mesh, inLink } of this.parts) mesh.matrix.multiplyMatrices(links[link], inLink);
  }

  dispose(): void {
    this.group.traverse((part) => {
      if (part instanceof Mesh || part instanceof LineSegments) part.geometry.dispose();
    });
  }
}

// Bodies of a scene, in their frames.

import { EdgesGeometry, Group, LineSegments, Mesh, type Matrix4 } from "three";
import type { LinkPoses } from "../../run/chain";
import type { Robot } from "../../run/run";
import type { Body } from "../../run/scene";
import type { BodyMaterials, Role } from "./body_materials";
import { createGeometry } from "./shapes";

const EDGE_DEG = 30;

interface PlacedBody {
  body: Body;
  mesh: Mesh;
}

export class Bodies {
  readonly group = new Group();
  private readonly placedBodies: PlacedBody[] = [];
  /** Frames moved by hand, with their offsets. */
  private readonly carriedFrames = new Set<number>();
  private displacement: Matrix4 | null = null;

  constructor(
    private readonly robot: Robot,
    private readonly bodyMaterials: BodyMaterials,
  ) {
    for (const body of robot.scene.bodies ?? []) {
      const mesh = new Mesh(createGeometry(body.shape, robot.meshes), bodyMaterials.solid[body.role]);
      mesh.matrixAutoUpdate = false;
      mesh.name = body.name;
      if (body.role !== "jet") this.addEdges(mesh, body);
      this.group.add(mesh);
      this.placedBodies.push({ body, mesh });
    }
  }

  private addEdges(mesh: Mesh, body: Body): void {
    if (body.shape.kind === "points") return;
    const edges = new LineSegments(new EdgesGeometry(mesh.geometry, EDGE_DEG), this.bodyMaterials.edges);
    edges.matrixAutoUpdate = false;
    edges.raycast = () => {};
    mesh.add(edges);
  }

  place({ frames }: LinkPoses, processOn: boolean): void {
    for (const { body, mesh } of this.placedBodies) {
      mesh.matrix.copy(frames[body.frame]);
      if (this.displacement && this.carriedFrames.has(body.frame)) mesh.matrix.premultiply(this.displacement);
      if (body.role === "jet") mesh.visible = processOn;
    }
  }

  show({ machine, cell }: { machine: boolean; cell: boolean }): void {
    for (const { body, mesh } of this.placedBodies) {
      if (body.role === "jet") mesh.visible &&= machine;
      else mesh.visible = body.role === "machine" ? machine : cell;
    }
  }

  /** Moves the contents of a frame, including attached frames, from now on; null: back to their place. */
  carry(frame: number, displacement: Matrix4 | null): void {
    this.displacement = displacement;
    this.carriedFrames.clear();
    this.robot.scene.frames?.forEach((each, i) => {
      if (i === frame || ("parent" in each && this.carriedFrames.has(each.parent))) this.carriedFrames.add(i);
    });
  }

  /** `look` returns the current look of a body, by its name; undefined: that of its role. */
  light(look: (name: string) => Role | undefined): void {
    for (const { body, mesh } of this.placedBodies) mesh.material = this.bodyMaterials.solid[look(body.name) ?? body.role];
  }

  dispose(): void {
    this.group.traverse((part) => {
      if (part instanceof Mesh || part instanceof LineSegments) part.geometry.dispose();
    });
  }
}

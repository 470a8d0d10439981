// Bodies of a scene, in their frames.

import { EdgesGeometry, Group, LineSegments, Mesh, type Matrix4 } from "three";
import type { Places } from "../../run/chain";
import type { Robot } from "../../run/run";
import type { Body } from "../../run/scene";
import type { Looks, Role } from "./looks";
import { geometryOf } from "./shapes";

const EDGE_DEG = 30;

interface Standing {
  body: Body;
  mesh: Mesh;
}

export class Bodies {
  readonly group = new Group();
  private readonly standing: Standing[] = [];
  /** Frames moved by hand, with their offsets. */
  private readonly carried = new Set<number>();
  private way: Matrix4 | null = null;

  constructor(
    private readonly robot: Robot,
    private readonly looks: Looks,
  ) {
    for (const body of robot.scene.bodies ?? []) {
      const mesh = new Mesh(geometryOf(body.shape, robot.meshes), looks.solid[body.role]);
      mesh.matrixAutoUpdate = false;
      mesh.name = body.name;
      if (body.role !== "jet") this.addEdges(mesh, body);
      this.group.add(mesh);
      this.standing.push({ body, mesh });
    }
  }

  private addEdges(mesh: Mesh, body: Body): void {
    if (body.shape.kind === "points") return;
    const edges = new LineSegments(new EdgesGeometry(mesh.geometry, EDGE_DEG), this.looks.edges);
    edges.matrixAutoUpdate = false;
    edges.raycast = () => {};
    mesh.add(edges);
  }

  place({ frames }: Places, processOn: boolean): void {
    for (const { body, mesh } of this.standing) {
      mesh.matrix.copy(frames[body.frame]);
      if (this.way && this.carried.has(body.frame)) mesh.matrix.premultiply(this.way);
      if (body.role === "jet") mesh.visible = processOn;
    }
  }

  show({ machine, cell }: { machine: boolean; cell: boolean }): void {
    for (const { body, mesh } of this.standing) {
      if (body.role === "jet") mesh.visible &&= machine;
      else mesh.visible = body.role === "machine" ? machine : cell;
    }
  }

  /** Moves the contents of a frame, including attached frames, from now on; null: back to their place. */
  carry(frame: number, way: Matrix4 | null): void {
    this.way = way;
    this.carried.clear();
    this.robot.scene.frames?.forEach((each, i) => {
      if (i === frame || ("parent" in each && this.carried.has(each.parent))) this.carried.add(i);
    });
  }

  /** `look` returns the current look of a body, by its name; undefined: that of its role. */
  light(look: (name: string) => Role | undefined): void {
    for (const { body, mesh } of this.standing) mesh.material = this.looks.solid[look(body.name) ?? body.role];
  }

  dispose(): void {
    this.group.traverse((part) => {
      if (part instanceof Mesh || part instanceof LineSegments) part.geometry.dispose();
    });
  }
}

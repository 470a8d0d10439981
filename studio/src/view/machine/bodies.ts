// The bodies of a scene, in their frames.

import { EdgesGeometry, Group, LineSegments, Mesh } from "three";
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

  constructor(
    robot: Robot,
    private readonly looks: Looks,
  ) {
    for (const body of robot.scene.bodies ?? []) {
      const mesh = new Mesh(geometryOf(body.shape, robot.meshes), looks.solid[body.role]);
      mesh.matrixAutoUpdate = false;
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
      if (body.role === "jet") mesh.visible = processOn;
    }
  }

  /** `look` tells how a body looks now, by its name; undefined: as its role does. */
  light(look: (name: string) => Role | undefined): void {
    for (const { body, mesh } of this.standing) mesh.material = this.looks.solid[look(body.name) ?? body.role];
  }

  dispose(): void {
    this.group.traverse((part) => {
      if (part instanceof Mesh || part instanceof LineSegments) part.geometry.dispose();
    });
  }
}

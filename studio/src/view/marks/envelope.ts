// Reach of the TCP, as a translucent body.

import { BufferAttribute, BufferGeometry, DoubleSide, EdgesGeometry, Group, LineBasicMaterial, LineSegments, Mesh, MeshBasicMaterial } from "three";
import type { Palette } from "../theme";
import { stlTriangles } from "./stl";

export class Envelope {
  readonly group = new Group();
  private readonly fill = new MeshBasicMaterial({ transparent: true, opacity: 0.12, depthWrite: false, side: DoubleSide });
  private readonly edge = new LineBasicMaterial({ transparent: true, opacity: 0.7 });
  private readonly surface = new Mesh(new BufferGeometry(), this.fill);
  private readonly edges = new LineSegments(new BufferGeometry(), this.edge);

  constructor() {
    this.surface.raycast = this.edges.raycast = () => {};
    this.group.add(this.surface, this.edges);
  }

  /** STL, mm. */
  setContent(bytes: Uint8Array): void {
    this.clear();
    this.surface.geometry.setAttribute("position", new BufferAttribute(stlTriangles(bytes), 3));
    this.edges.geometry = new EdgesGeometry(this.surface.geometry, 20);
  }

  clear(): void {
    for (const part of [this.surface, this.edges]) {
      part.geometry.dispose();
      part.geometry = new BufferGeometry();
    }
  }

  recolour(colours: Palette): void {
    this.fill.color.copy(colours.envelope);
    this.edge.color.copy(colours.envelope);
  }
}

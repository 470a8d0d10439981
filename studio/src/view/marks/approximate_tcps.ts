// Dots at the TCPs, until the joints of a long run are loaded.

import { Group, Mesh, MeshBasicMaterial, SphereGeometry, type Vector3 } from "three";
import type { Palette } from "../theme";

const RADIUS_PX = 5;

export class ApproximateTcps {
  readonly group = new Group();
  private readonly material = new MeshBasicMaterial();
  private readonly geometry = new SphereGeometry(1, 16, 12);

  recolour(colours: Palette): void {
    this.material.color.copy(colours.selected);
  }

  put(places: Vector3[], mmPerPixelAt: (place: Vector3) => number): void {
    while (this.group.children.length < places.length) {
      const dot = new Mesh(this.geometry, this.material);
      dot.raycast = () => {};
      this.group.add(dot);
    }
    this.group.children.forEach((dot, i) => {
      dot.visible = i < places.length;
      if (dot.visible) dot.position.copy(places[i]);
      if (dot.visible) dot.scale.setScalar(RADIUS_PX * mmPerPixelAt(places[i]));
    });
  }
}

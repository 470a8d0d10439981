// Box around the path, with its sizes.

import { Box3, BufferGeometry, LineBasicMaterial, LineSegments, type Matrix4, Vector3 } from "three";
import type { Units } from "../../core/store";
import { lengthText } from "../../core/units";
import type { Palette } from "../theme";
import { boxEdges, setLines } from "./grid";
import type { Label } from "./labels";

export class Extents {
  readonly lines = new LineSegments(new BufferGeometry(), new LineBasicMaterial());
  private readonly box = new Box3();

  constructor() {
    this.lines.matrixAutoUpdate = false;
    this.lines.visible = false;
    this.lines.frustumCulled = false;
    this.lines.raycast = () => {};
  }

  setContent(box: Box3): void {
    this.box.copy(box);
    setLines(this.lines, box.isEmpty() ? [] : boxEdges(box));
  }

  recolour(colours: Palette): void {
    this.lines.material.color.copy(colours.marks);
  }

  labels(units: Units, frame: Matrix4): Label[] {
    if (!this.lines.visible || this.box.isEmpty()) return [];
    const { min, max } = this.box;
    const size = this.box.getSize(new Vector3());
    const at = (x: number, y: number, z: number) => new Vector3(x, y, z).applyMatrix4(frame);
    const text = (axis: string, mm: number) => `${axis} ${lengthText(mm, units)}`;
    return [
      { at: at((min.x + max.x) / 2, min.y, min.z), text: text("X", size.x), kind: "size" },
      { at: at(max.x, (min.y + max.y) / 2, min.z), text: text("Y", size.y), kind: "size" },
      { at: at(max.x, min.y, (min.z + max.z) / 2), text: text("Z", size.z), kind: "size" },
    ];
  }
}

// Grid in round numbers on the work plane.

import { Box3, BufferAttribute, BufferGeometry, Group, LineBasicMaterial, LineSegments } from "three";
import { length, toMm } from "../../core/units";
import type { Units } from "../../core/store";
import type { Palette } from "../theme";

const LINES = 24;
const BOLD_INTERVAL = 5;

const lineMaterial = (opacity: number) => new LineBasicMaterial({ transparent: true, opacity, depthWrite: false });

/** Returns the next 1, 2 or 5 times a power of ten that is not less. */
export function roundUp(value: number): number {
  const power = 10 ** Math.floor(Math.log10(value));
  return power * (value <= power ? 1 : value <= 2 * power ? 2 : value <= 5 * power ? 5 : 10);
}

export class Grid {
  readonly group = new Group();
  /** Between lines, mm. */
  step_mm = 0;
  private readonly fine = new LineSegments(new BufferGeometry(), lineMaterial(0.4));
  readonly boldLines = new LineSegments(new BufferGeometry(), lineMaterial(0.75));

  constructor() {
    this.group.matrixAutoUpdate = false;
    for (const lines of [this.fine, this.boldLines]) {
      lines.raycast = () => {};
      lines.frustumCulled = false;
      this.group.add(lines);
    }
  }

  /** Places it under a box in the work frame. */
  layOut(box: Box3, units: Units): void {
    const size_mm = Math.max(box.max.x - box.min.x, box.max.y - box.min.y, 1);
    this.step_mm = toMm(roundUp((1.6 * length(size_mm, units)) / LINES), units);
    const wide = BOLD_INTERVAL * this.step_mm;
    const margin = 0.3 * size_mm;
    const [x0, y0] = [box.min.x, box.min.y].map((low) => Math.floor((low - margin) / wide) * wide);
    const [x1, y1] = [box.max.x, box.max.y].map((high) => Math.ceil((high + margin) / wide) * wide);
    const fine: number[] = [];
    const boldLines: number[] = [];
    const lines = (from: number, to: number, put: (at: number, into: number[]) => void) => {
      for (let i = Math.round(from / this.step_mm); i <= Math.round(to / this.step_mm); ++i) {
        put(i * this.step_mm, i % BOLD_INTERVAL === 0 ? boldLines : fine);
      }
    };
    lines(x0, x1, (x, into) => into.push(x, y0, 0, x, y1, 0));
    lines(y0, y1, (y, into) => into.push(x0, y, 0, x1, y, 0));
    setLines(this.fine, fine);
    setLines(this.boldLines, boldLines);
  }

  recolour(colours: Palette): void {
    this.fine.material.color.copy(colours.grid);
    this.boldLines.material.color.copy(colours.grid);
  }
}

/** Sets the coordinates of ends of lines, three for each. */
export function setLines(lines: LineSegments, ends: number[]): void {
  lines.geometry.dispose();
  lines.geometry = new BufferGeometry().setAttribute("position", new BufferAttribute(new Float32Array(ends), 3));
}

/** Returns the ends of the twelve edges of a box. */
export function boxEdges({ min, max }: Box3): number[] {
  const ends: number[] = [];
  const corner = (i: number) => [i & 1 ? max.x : min.x, i & 2 ? max.y : min.y, i & 4 ? max.z : min.z];
  for (let i = 0; i < 8; ++i) for (const bit of [1, 2, 4]) if (!(i & bit)) ends.push(...corner(i), ...corner(i | bit));
  return ends;
}

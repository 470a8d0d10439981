// Distance between two picked positions, in the work frame.

import { BufferGeometry, LineBasicMaterial, LineSegments, type Matrix4, Vector3 } from "three";
import type { Units } from "../../core/store";
import { lengthNumber, lengthText, lengthUnit } from "../../core/units";
import type { Palette } from "../theme";
import { setLines } from "./grid";
import type { Label } from "./labels";

export class Measure {
  readonly lines = new LineSegments(
    new BufferGeometry(),
    new LineBasicMaterial({ depthTest: false, transparent: true }),
  );
  /** One or two positions, in the work frame of the shown robot (mm). */
  private places: Vector3[] = [];

  constructor() {
    this.lines.matrixAutoUpdate = false;
    this.lines.frustumCulled = false;
    this.lines.renderOrder = 10;
    this.lines.raycast = () => {};
  }

  clear(): void {
    this.places = [];
    this.draw();
  }

  /** Picks a position; a third one starts again. */
  pick(place: Vector3): void {
    if (this.places.length === 2) this.places = [];
    this.places.push(place);
    this.draw();
  }

  private draw(): void {
    const [a, b] = this.places;
    this.lines.visible = b !== undefined;
    if (!b) return;
    // Straight line, and path along the axes.
    const corners = [a, new Vector3(b.x, a.y, a.z), new Vector3(b.x, b.y, a.z), b];
    const ends = [...a.toArray(), ...b.toArray()];
    for (let i = 0; i < 3; ++i) ends.push(...corners[i].toArray(), ...corners[i + 1].toArray());
    setLines(this.lines, ends);
  }

  recolour(colours: Palette): void {
    this.lines.material.color.copy(colours.measure);
  }

  /** Returns "dx 1.000  dy 2.000  dz 0.000  distance 2.236 mm"; empty: two positions are not picked yet. */
  text(units: Units, distance: string): string {
    const [a, b] = this.places;
    if (!b) return "";
    const way = b.clone().sub(a);
    const number = (mm: number) => lengthNumber(mm, units);
    const parts = [`dx ${number(way.x)}`, `dy ${number(way.y)}`, `dz ${number(way.z)}`];
    return `${parts.join("  ")}  ${distance} ${number(way.length())} ${lengthUnit(units)}`;
  }

  labels(units: Units, frame: Matrix4): Label[] {
    const [a, b] = this.places;
    const dots = this.places.map((place) => ({ at: place.clone().applyMatrix4(frame), text: "", kind: "dot" }));
    if (!b) return dots;
    const at = a.clone().add(b).multiplyScalar(0.5).applyMatrix4(frame);
    return [...dots, { at, text: lengthText(a.distanceTo(b), units), kind: "measured" }];
  }
}

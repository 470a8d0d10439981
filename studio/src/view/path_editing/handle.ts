// Handle of a point: arrows, a dot and rings of constant size on the screen, and the direction of the tool.

import {
  BufferGeometry,
  Color,
  ConeGeometry,
  Group,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  MeshBasicMaterial,
  SphereGeometry,
  Vector3,
} from "three";
import { blue, green, vermilion } from "../../core/colours";
import { setLines } from "../marks/grid";
import type { Palette } from "../theme";
import { ARROW_PX, RING_PX, ringPoint, handleScale, unitVector, type HandleGrip, type HandleContext } from "./handle_grips";

const colours = [vermilion, green, blue].map((colour) => new Color(colour));
const DOT_PX = 6;
const CONE_PX = 16;
const RING_STEPS = 64;
const TOOL_PX = 110;

const lineMaterial = () => new LineBasicMaterial({ depthTest: false, transparent: true });
const solidMaterial = () => new MeshBasicMaterial({ depthTest: false, transparent: true });

function createRing(axis: number): LineSegments<BufferGeometry, LineBasicMaterial> {
  const ring = new LineSegments(new BufferGeometry(), lineMaterial());
  const at = (i: number) => ringPoint(axis, (2 * Math.PI * i) / RING_STEPS).multiplyScalar(RING_PX).toArray();
  setLines(ring, Array.from({ length: RING_STEPS }, (_, i) => [...at(i), ...at(i + 1)]).flat());
  return ring;
}

function createArrow(axis: number) {
  const line = new LineSegments(new BufferGeometry(), lineMaterial());
  setLines(line, [0, 0, 0, ...unitVector(axis).multiplyScalar(ARROW_PX).toArray()]);
  const cone = new Mesh(new ConeGeometry(5, CONE_PX, 16), solidMaterial());
  cone.quaternion.setFromUnitVectors(new Vector3(0, 1, 0), unitVector(axis));
  cone.position.copy(unitVector(axis)).multiplyScalar(ARROW_PX - CONE_PX / 2);
  return { line, cone };
}

export class Handle {
  readonly group = new Group();
  private readonly scaled = new Group();
  private readonly arrows = [0, 1, 2].map(createArrow);
  private readonly rings = [0, 1, 2].map(createRing);
  private readonly dot = new Mesh(new SphereGeometry(DOT_PX, 16, 12), solidMaterial());
  private readonly tool = new LineSegments(new BufferGeometry(), lineMaterial());
  private selected = new Color();

  constructor() {
    this.group.matrixAutoUpdate = false;
    this.group.add(this.scaled);
    const arrows = this.arrows.flatMap(({ line, cone }) => [line, cone]);
    for (const part of [...this.rings, ...arrows, this.tool, this.dot]) {
      part.frustumCulled = false;
      part.renderOrder = 2;
      this.scaled.add(part);
    }
  }

  recolour(palette: Palette): void {
    this.selected = palette.selected;
    this.tool.material.color.copy(palette.selected);
  }

  /**
   * Places it at a point; `up` is the direction to the tool from there (null: not known, or none), `held` the
   * grabbed grip, `turns` true if it has rings.
   */
  place(handleContext: HandleContext, up: Vector3 | null, held: HandleGrip | null, turns = up !== null): void {
    this.group.matrix.copy(handleContext.work);
    this.scaled.position.copy(handleContext.at);
    this.scaled.scale.setScalar(handleScale(handleContext));
    this.tool.visible = up !== null;
    if (up) setLines(this.tool, [0, 0, 0, ...up.clone().setLength(TOOL_PX).toArray()]);
    const gripColour = (kind: HandleGrip["kind"], axis: number) =>
      held?.kind === kind && (kind === "plane" || held.axis === axis) ? this.selected : colours[axis];
    this.dot.material.color.copy(held?.kind === "plane" ? this.selected : this.tool.material.color);
    for (const axis of [0, 1, 2]) {
      const { line, cone } = this.arrows[axis];
      line.material.color.copy(gripColour("move", axis));
      cone.material.color.copy(gripColour("move", axis));
      this.rings[axis].visible = turns;
      this.rings[axis].material.color.copy(gripColour("turn", axis));
      this.rings[axis].material.opacity = held?.kind === "turn" && held.axis === axis ? 1 : 0.55;
    }
  }
}

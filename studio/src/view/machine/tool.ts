// Tool: a shank from the tool centre point (without tool offset) to the TCP and beyond, the TCP itself, and
// the jet.

import { ConeGeometry, Group, Matrix4, Mesh, Vector3 } from "three";
import type { LinkPoses } from "../../run/chain";
import type { Robot } from "../../run/run";
import type { BodyMaterials } from "./body_materials";
import { cylinder } from "./shapes";

const JET_MM = 1;
// Thickness relative to the round size of the machine's parts; a tool with its own bodies only gets a point.
const SHANK_RADIUS_SHARE = 0.16;
const POINT_RADIUS_SHARE = 0.04;

/** Returns the distance from the tool centre point to the tool holder, along the tool's Z, mm. */
const holderDistance_mm = (robot: Robot): number => new Matrix4().fromArray(robot.scene.tool_side.end).invert().elements[14];

/** Returns the direction of the tool from its TCP: up if it cannot be determined otherwise. */
function shankSign(robot: Robot): number {
  const away = holderDistance_mm(robot);
  if (Math.abs(away) > 1) return Math.sign(away);
  const home = robot.chain.linkPoses(new Float64Array(robot.scene.axes.length), 0);
  return home.tool.elements[10] < -1e-6 ? -1 : 1;
}

export class Tool {
  readonly group = new Group();
  private readonly shank = new Mesh();
  private readonly point = new Mesh();
  private readonly jet = new Mesh();
  private readonly sign: number;
  private readonly jets: boolean;
  private readonly radius_mm: number;

  constructor(
    private readonly robot: Robot,
    bodyMaterials: BodyMaterials,
    /** Round size of the machine's parts. */
    private readonly partSize_mm: number,
    hasBodies: boolean,
  ) {
    this.sign = shankSign(robot);
    const bodies = robot.scene.bodies ?? [];
    this.jets = robot.scene.process === "jet" && !bodies.some((body) => body.role === "jet");
    this.shank.visible = !hasBodies;
    const radius = (hasBodies ? POINT_RADIUS_SHARE : SHANK_RADIUS_SHARE) * partSize_mm;
    this.radius_mm = radius;
    // Cone with its point at the bottom.
    this.point.geometry = new ConeGeometry(radius, 3 * radius, 24).rotateX(-Math.PI / 2).translate(0, 0, 1.5 * radius);
    this.shank.geometry = cylinder(radius, 1).translate(0, 0, 0.5);
    this.jet.geometry = cylinder(JET_MM, 1).translate(0, 0, -0.5);
    this.point.material = this.shank.material = bodyMaterials.solid.tool;
    this.jet.material = bodyMaterials.solid.jet;
    for (const mesh of [this.shank, this.point, this.jet]) {
      mesh.matrixAutoUpdate = false;
      this.group.add(mesh);
    }
  }

  /** Returns the position of a tool's TCP in the world. */
  tip(linkPoses: LinkPoses, tip: number): Vector3 {
    return new Vector3(...(this.robot.scene.tcps_mm[tip] ?? [0, 0, 0])).applyMatrix4(linkPoses.tool);
  }

  place(linkPoses: LinkPoses, tip: number, processOn: boolean): void {
    const offset = new Vector3(...(this.robot.scene.tcps_mm[tip] ?? [0, 0, 0]));
    const columnBase = linkPoses.tool.clone().multiply(new Matrix4().makeTranslation(offset.x, offset.y, offset.z));
    if (this.sign < 0) columnBase.multiply(new Matrix4().makeRotationX(Math.PI));
    this.point.matrix.copy(columnBase);
    const radius = this.radius_mm;
    const beyond = Math.max(0, -this.sign * offset.z) + Math.max(1.6 * this.partSize_mm, Math.abs(holderDistance_mm(this.robot)));
    this.shank.matrix.copy(columnBase).multiply(stretchMatrix(1, 3 * radius, beyond - 3 * radius));
    this.jet.visible = this.jets && processOn;
    const width = Math.max(1, 0.02 * this.partSize_mm);
    this.jet.matrix.copy(columnBase).multiply(stretchMatrix(width, 0, 0.8 * this.partSize_mm));
  }

  dispose(): void {
    for (const mesh of [this.shank, this.point, this.jet]) mesh.geometry.dispose();
  }
}

const stretchMatrix = (across: number, from_mm: number, length_mm: number): Matrix4 =>
  new Matrix4().makeTranslation(0, 0, from_mm).scale(new Vector3(across, across, length_mm));

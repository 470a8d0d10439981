// Zones of a machine: the tool stays inside some and outside others.

import {
  Box3,
  BoxGeometry,
  DoubleSide,
  EdgesGeometry,
  Group,
  LineBasicMaterial,
  LineSegments,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  Vector3,
} from "three";
import { matrixOf } from "../../run/chain";
import type { Robot } from "../../run/run";
import type { Zone } from "../../run/scene";
import type { Palette } from "../theme";

const fill = (opacity: number) =>
  new MeshBasicMaterial({ transparent: true, opacity, depthWrite: false, side: DoubleSide });

export class Zones {
  readonly group = new Group();
  private readonly fills = { inside: fill(0.06), outside: fill(0.22) };
  private readonly edges = { inside: new LineBasicMaterial(), outside: new LineBasicMaterial() };

  setContent(robots: readonly Robot[], reach: (robot: number) => Box3): void {
    this.group.traverse((part) => {
      if (part instanceof Mesh || part instanceof LineSegments) part.geometry.dispose();
    });
    this.group.clear();
    robots.forEach((robot, i) => {
      const { axis_space, zones, axes } = robot.scene;
      if (!axis_space) return;
      const work = robot.chain.linkPoses(new Float64Array(axes.length), 0).work;
      const frame = work.multiply(matrixOf(axis_space));
      for (const zone of zones) if (zone.on) this.add(zone, robot, reach(i), frame);
    });
  }

  private add(zone: Zone, robot: Robot, reach: Box3, frame: Matrix4): void {
    const box = zoneBox(zone, robot, reach);
    const size = box.getSize(new Vector3());
    const kind = zone.inside ? "inside" : "outside";
    const geometry = new BoxGeometry(size.x, size.y, size.z);
    const mesh = new Mesh(geometry, this.fills[kind]);
    mesh.add(new LineSegments(new EdgesGeometry(geometry), this.edges[kind]));
    mesh.applyMatrix4(frame.clone().multiply(new Matrix4().setPosition(box.getCenter(new Vector3()))));
    this.group.add(mesh);
  }

  recolour(colours: Palette): void {
    for (const kind of ["inside", "outside"] as const) {
      this.fills[kind].color.copy(colours[kind]);
      this.edges[kind].color.copy(colours[kind]);
    }
  }
}

// A zone without a wall extends to the end of the axis, or as far as the work.
function zoneBox(zone: Zone, { scene }: Robot, reach: Box3): Box3 {
  const box = new Box3();
  scene.position_joints.forEach((joint, i) => {
    const axis = scene.axes[joint];
    const low = zone.min_mm[i] ?? axis?.min ?? Math.min(reach.min.getComponent(i), zone.max_mm[i] ?? Infinity) - 50;
    const high = zone.max_mm[i] ?? axis?.max ?? Math.max(reach.max.getComponent(i), low) + 50;
    box.min.setComponent(i, Math.min(low, high));
    box.max.setComponent(i, Math.max(low, high));
  });
  return box;
}

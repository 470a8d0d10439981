// One robot of a run: its bodies, or a substitute for them, and its tool.

import { Group, Vector3 } from "three";
import type { LinkPoses } from "../../run/chain";
import { Flag } from "../../run/kinds";
import type { Report } from "../../run/report";
import type { Robot } from "../../run/run";
import { Bodies } from "./bodies";
import { createSkeleton } from "./skeleton";
import type { BodyMaterials } from "./body_materials";
import type { Parts } from "./parts";
import { createStandIn } from "./standin";
import { Tool } from "./tool";
import { travels } from "./travel";

/** A robot at an instant. */
export interface Instant {
  linkPoses: LinkPoses;
  /** Active segment; -1: nothing moves. */
  segment: number;
  tip: number;
  tip_mm: Vector3;
  processOn: boolean;
  /** True if the joints are not loaded yet: the machine keeps its last known pose, the TCP is on the path. */
  isApproximate: boolean;
}

const toolHasBodies = ({ scene }: Robot): boolean => {
  const tool = scene.frames?.findIndex((frame) => frame.name === "tool") ?? -1;
  return (scene.bodies ?? []).some((body) => {
    const frame = scene.frames?.[body.frame];
    return body.role === "machine" && frame && "parent" in frame && frame.parent === tool;
  });
};

export class Machine {
  readonly group = new Group();
  readonly bodies: Bodies;
  private readonly standIn: Parts | null;
  private readonly tool: Tool;
  /** As they were known last. */
  private joints: ArrayLike<number>;
  private tip = 0;

  constructor(
    readonly robot: Robot,
    report: Report | null,
    bodyMaterials: BodyMaterials,
  ) {
    this.bodies = new Bodies(robot, bodyMaterials);
    this.standIn = createStandIn(robot, report, bodyMaterials);
    this.joints = robot.home;
    const zero = robot.chain.linkPoses(new Float64Array(robot.scene.axes.length), 0);
    const { partSize_mm } = createSkeleton(robot.scene, zero, travels(robot, report));
    this.tool = new Tool(robot, bodyMaterials, partSize_mm, toolHasBodies(robot));
    this.group.add(this.bodies.group, this.tool.group);
    if (this.standIn) this.group.add(this.standIn.group);
    this.group.matrixAutoUpdate = false;
  }

  /** Returns the state at an instant of the run; `jog`: with other joints (mm, rad), at standstill. */
  at(t_s: number, jog: ArrayLike<number> | null = null): Instant {
    const { robot } = this;
    const known = jog ?? robot.joints_at(t_s);
    this.joints = known ?? this.joints;
    const linkPoses = robot.chain.linkPoses(this.joints, t_s);
    const segment = robot.segments.at(t_s);
    this.tip = robot.tcp_at(t_s) ?? this.tip;
    const flags = jog === null && t_s < robot.segments.end_s ? robot.segments.flagsAt(t_s) : null;
    const drawn = known ? null : robot.segments.tip_mm(t_s);
    const tip_mm = drawn ? new Vector3(...drawn).applyMatrix4(linkPoses.work) : this.tool.tip(linkPoses, this.tip);
    const processOn = flags !== null && (flags & Flag.processOn) !== 0;
    return { linkPoses, segment, tip: this.tip, tip_mm, processOn, isApproximate: !known };
  }

  place({ linkPoses, tip, processOn }: Instant): void {
    this.bodies.place(linkPoses, processOn);
    this.standIn?.place(linkPoses);
    this.tool.place(linkPoses, tip, processOn);
  }

  show(of: { machine: boolean; cell: boolean }): void {
    this.bodies.show(of);
    this.tool.group.visible = of.machine;
    if (this.standIn) this.standIn.group.visible = of.machine;
  }

  dispose(): void {
    this.bodies.dispose();
    this.standIn?.dispose();
    this.tool.dispose();
  }
}

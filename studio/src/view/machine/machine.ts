// One robot of a run: its bodies, or what stands in for them, and its tool.

import { Group, Vector3 } from "three";
import type { Places } from "../../run/chain";
import type { Report } from "../../run/report";
import type { Robot } from "../../run/run";
import { Bodies } from "./bodies";
import { skeletonOf } from "./frame_of_axes";
import type { Looks } from "./looks";
import type { Parts } from "./parts";
import { standInFor } from "./standin";
import { Tool } from "./tool";
import { travels } from "./travel";

/** A robot at an instant. */
export interface Instant {
  places: Places;
  /** The segment under way; -1: nothing moves. */
  segment: number;
  tip: number;
  tip_mm: Vector3;
  processOn: boolean;
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

  constructor(
    readonly robot: Robot,
    report: Report | null,
    looks: Looks,
  ) {
    this.bodies = new Bodies(robot, looks);
    this.standIn = standInFor(robot, report, looks);
    const zero = robot.chain.places(new Float64Array(robot.scene.axes.length), 0);
    const { gauge_mm } = skeletonOf(robot.scene, zero, travels(robot, report));
    this.tool = new Tool(robot, looks, gauge_mm, toolHasBodies(robot));
    this.group.add(this.bodies.group, this.tool.group);
    if (this.standIn) this.group.add(this.standIn.group);
    this.group.matrixAutoUpdate = false;
  }

  at(t_s: number): Instant {
    const { robot } = this;
    const places = robot.chain.places(robot.joints_at(t_s), t_s);
    const segment = robot.segments.at(t_s);
    const info = segment >= 0 ? robot.segments.info(segment) : null;
    const tip = info?.tip ?? 0;
    const during = info !== null && t_s < info.start_s + info.duration_s;
    return { places, segment, tip, tip_mm: this.tool.tip(places, tip), processOn: during && info.processOn };
  }

  place({ places, tip, processOn }: Instant): void {
    this.bodies.place(places, processOn);
    this.standIn?.place(places);
    this.tool.place(places, tip, processOn);
  }

  dispose(): void {
    this.bodies.dispose();
    this.standIn?.dispose();
    this.tool.dispose();
  }
}

// Drawing from the joints for a machine without known bodies.

import type { Robot } from "../../run/run";
import type { Report } from "../../run/report";
import type { Scene } from "../../run/scene";
import { buildArm } from "./arm";
import { skeletonOf } from "./frame_of_axes";
import { buildGantry, isGantry } from "./gantry";
import type { Looks } from "./looks";
import { Parts } from "./parts";
import { travels } from "./travel";
import { buildTable } from "./worktable";

/** Returns the links (0 the world) that have bodies of the machine. */
function linksWithBodies({ frames = [], bodies = [] }: Scene): Set<number> {
  const linkOf = (index: number): number => {
    const frame = frames[index];
    return "link" in frame ? frame.link : linkOf(frame.parent);
  };
  return new Set(bodies.filter((body) => body.role === "machine").map((body) => linkOf(body.frame)));
}

/** Returns null if its bodies show the machine well enough. */
export function standInFor(robot: Robot, report: Report | null, looks: Looks): Parts | null {
  const { scene, chain } = robot;
  const known = linksWithBodies(scene);
  known.delete(0);
  if (2 * known.size >= scene.axes.length) return null;
  const zero = chain.places(new Float64Array(scene.axes.length), 0);
  const parts = new Parts(zero, looks);
  const skeleton = skeletonOf(scene, zero, travels(robot, report));
  const gantry = isGantry(skeleton);
  if (gantry) buildGantry(parts, skeleton);
  else buildArm(parts, skeleton);
  const hasTable = scene.bodies?.some((body) => body.role === "fixture" || body.role === "workpiece");
  if (gantry && !hasTable) buildTable(parts, skeleton);
  return parts;
}

// Drawing from the joints for a machine without known bodies.

import type { Robot } from "../../run/run";
import type { Report } from "../../run/report";
import type { Scene } from "../../run/scene";
import { buildArm } from "./arm";
import { createSkeleton } from "./skeleton";
import { buildGantry, isGantry } from "./gantry";
import type { BodyMaterials } from "./body_materials";
import { Parts } from "./parts";
import { travels } from "./travel";
import { buildTable } from "./worktable";

/** Returns the links (0 the world) that have bodies of the machine. */
function linksWithBodies({ frames = [], bodies = [] }: Scene): Set<number> {
  const frameLink = (index: number): number => {
    const frame = frames[index];
    return "link" in frame ? frame.link : frameLink(frame.parent);
  };
  return new Set(bodies.filter((body) => body.role === "machine").map((body) => frameLink(body.frame)));
}

/** Returns null if its bodies show the machine well enough. */
export function createStandIn(robot: Robot, report: Report | null, bodyMaterials: BodyMaterials): Parts | null {
  const { scene, chain } = robot;
  const known = linksWithBodies(scene);
  known.delete(0);
  if (2 * known.size >= scene.axes.length) return null;
  const zero = chain.linkPoses(new Float64Array(scene.axes.length), 0);
  const parts = new Parts(zero, bodyMaterials);
  const skeleton = createSkeleton(scene, zero, travels(robot, report));
  const gantry = isGantry(skeleton);
  if (gantry) buildGantry(parts, skeleton);
  else buildArm(parts, skeleton);
  const hasTable = scene.bodies?.some((body) => body.role === "fixture" || body.role === "workpiece");
  if (gantry && !hasTable) buildTable(parts, skeleton);
  return parts;
}

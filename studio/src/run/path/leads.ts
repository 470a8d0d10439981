// Leads: paths through the waste that enter the first cut of a contour along its tangent, and leave after its
// last one.

import { texts } from "../../texts";
import { arcDirection } from "./path_arc";
import { insertTargets, setTarget } from "./path_edit";
import { isPoint, isSameTarget, targetKey, pointAt, type PathFile, type TargetId, type Point, type Target } from "./path_file";
import { stateAfter, type Motion, type State, type PathTraversal } from "./path_traversal";
import { add, cross, distance, dot, vectorLength, roundedVector, scaled, subtract, unit, type Vector } from "./vector";

export interface LeadChoice {
  kind: "arc" | "line";
  /** Radius of the arc, a quarter circle; length of the line. */
  size_mm: number;
  /** Angle of the line from the direction of the cut, 0 to 90. */
  angle_deg: number;
  /** Side of the cut, seen along its direction, with the tool upright. */
  side: "left" | "right";
  into: boolean;
  out: boolean;
}

const words = texts.paths.leads;
const TOLERANCE_MM = 1e-4;
const RAD_PER_DEG = Math.PI / 180;

const directionAt = (motion: Motion, share: number): Vector | null =>
  motion.arc ? arcDirection(motion.arc, share) : unit(subtract(motion.to_mm, motion.from_mm!));

/** Returns the direction from the TCP to the tool holder, if the path defines it by a direction. */
export const upDirection = ({ tool_axis }: State): Vector => (tool_axis && unit(tool_axis)) ?? [0, 0, 1];

const isCut = (motion: Motion): boolean =>
  !motion.rapid && motion.from_mm !== null && (motion.arc !== null || distance(motion.from_mm, motion.to_mm) > TOLERANCE_MM);

/** Returns the outer end of a lead: `sense` is -1 for a lead-in, 1 for a lead-out. */
function leadEnd(at: Vector, along: Vector, lateral: Vector, choice: LeadChoice, sense: 1 | -1): Vector {
  const { kind, size_mm, angle_deg } = choice;
  const forward = kind === "arc" ? 1 : Math.cos(angle_deg * RAD_PER_DEG);
  const sideways = kind === "arc" ? 1 : Math.sin(angle_deg * RAD_PER_DEG);
  return roundedVector(add(at, add(scaled(along, sense * forward * size_mm), scaled(lateral, sideways * size_mm))));
}

function leadPoint(to: Vector, at: Vector, along: Vector, lateral: Vector, { kind, size_mm }: LeadChoice): Point {
  if (kind === "line") return { motion: "linear", position_mm: to };
  const center_mm = roundedVector(add(at, scaled(lateral, size_mm)));
  return { motion: "circular", position_mm: to, center_mm, normal: roundedVector(cross(along, lateral)), turn_deg: 90 };
}

/** True if a target is at a position, or above it along the tool. */
function isAbove(target: Target | undefined, at: Vector, up: Vector): target is Point {
  if (!target || !isPoint(target)) return false;
  const off = subtract(target.position_mm, at);
  return vectorLength(subtract(off, scaled(up, dot(off, up)))) < TOLERANCE_MM;
}

class Leads {
  private readonly targets: Target[];

  constructor(
    private text: string,
    private readonly file: PathFile,
    private readonly walk: PathTraversal,
    private readonly path: number,
    private readonly choice: LeadChoice,
  ) {
    this.targets = file.paths[path].targets;
  }

  add(first: number, count: number): string | { error: string } {
    const inside = ({ place }: Motion) => place.path === this.path && place.target >= first && place.target < first + count;
    const cuts = this.walk.motions.filter((motion) => inside(motion) && isCut(motion));
    cuts.sort((a, b) => a.place.target - b.place.target);
    if (cuts.length === 0) return { error: words.noCut };
    // The lead-out comes first, so that target numbers stay valid.
    if (this.choice.out) this.leadOut(cuts.at(-1)!);
    if (this.choice.into) this.leadIn(cuts[0]);
    return this.text;
  }

  private place(target: number): TargetId {
    return { path: this.path, target };
  }

  private before({ place }: Motion): State {
    return this.walk.before.get(targetKey(place)) ?? {};
  }

  private sideDirection(along: Vector, up: Vector): Vector {
    const left = unit(cross(up, along)) ?? [1, 0, 0];
    return this.choice.side === "left" ? left : scaled(left, -1);
  }

  /** Moves the targets at an end of the cut, and above it, to the end of the lead. */
  private shift(from: number, step: 1 | -1, at: Vector, by: Vector, up: Vector): void {
    for (let i = from; isAbove(this.targets[i], at, up); i += step) {
      const { position_mm } = this.targets[i] as Point;
      this.text = setTarget(this.text, this.place(i), { position_mm: roundedVector(add(position_mm, by)) });
    }
  }

  private leadIn(cut: Motion): void {
    const at = cut.from_mm!;
    const up = upDirection(this.before(cut));
    const along = directionAt(cut, 0)!;
    const lateral = this.sideDirection(along, up);
    const start = leadEnd(at, along, lateral, this.choice, -1);
    const { target } = cut.place;
    const { feed_mm_min } = pointAt(this.file, cut.place)!;
    const lead = { ...leadPoint(at, at, along, lateral, this.choice), feed_mm_min };
    // A cut that continues from another path is left, and begun again.
    const isContinued = !isSameTarget(cut.after, this.place(target - 1));
    if (!isContinued) this.shift(target - 1, -1, at, subtract(start, at), up);
    const added: Point[] = isContinued ? [{ motion: "rapid", position_mm: start }, lead] : [lead];
    this.text = insertTargets(this.text, this.path, target, added);
  }

  private leadOut(cut: Motion): void {
    const at = cut.to_mm;
    const point = pointAt(this.file, cut.place)!;
    const up = upDirection(stateAfter(this.before(cut), point));
    const along = directionAt(cut, 1)!;
    const lateral = this.sideDirection(along, up);
    const end = leadEnd(at, along, lateral, this.choice, 1);
    const { actions, dwell_s } = point;
    const lead = { ...leadPoint(end, at, along, lateral, this.choice), dwell_s, actions };
    const { target } = cut.place;
    this.shift(target + 1, 1, at, subtract(end, at), up);
    this.text = setTarget(this.text, cut.place, { dwell_s: undefined, actions: undefined });
    this.text = insertTargets(this.text, this.path, target + 1, [lead]);
  }
}

/**
 * Returns the text with leads at the ends of the cuts among some targets of a path, or a message if they have
 * no cut.
 */
export const addLeads = (
  text: string,
  file: PathFile,
  walk: PathTraversal,
  { path, target }: TargetId,
  count: number,
  choice: LeadChoice,
): string | { error: string } => new Leads(text, file, walk, path, choice).add(target, count);

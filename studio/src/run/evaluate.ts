// Position, speed and acceleration of the joints in a segment, from its record (docs/studio.md).

import { ARC_SIZE, arcAt } from "./arc";
import { Flag } from "./kinds";
import { HEAD_SIZE, headAt, headLength_rad } from "./orientation_arc";
import { addBreaks_s, lawAt, lawDuration_s, lawLength, lawSize, type LawState } from "./time_law";

/** Values of the joints, mm or rad, with their first and second time derivatives. */
export interface JointState {
  position: Float64Array;
  velocity: Float64Array;
  acceleration: Float64Array;
}

/** Records of one chunk, and the number of joints in each. */
export interface Records {
  values: Float64Array;
  joints: number;
}

export interface SegmentRecord {
  at: number;
  flags: number;
  duration_s: number;
}

// After its end, a law that is shorter than its segment is at standstill.
function lawState(values: Float64Array, law: number, waits: boolean, t_s: number): LawState {
  if (waits && t_s > lawDuration_s(values, law)) return { s: lawLength(values, law), v: 0, a: 0 };
  return lawAt(values, law, t_s);
}

/** Offsets of the parts of a record; -1: none. */
interface Layout {
  lead: number;
  arc: number;
  head: number;
  followers: number;
  uncoordinated: number;
  superimposed: SegmentRecord | null;
}

function recordLayout({ values, joints }: Records, { at, flags }: SegmentRecord): Layout {
  const lead = at + 2 * joints;
  let next = lead + lawSize(values, lead);
  const arc = flags & Flag.arc ? next : -1;
  if (arc >= 0) next += ARC_SIZE;
  const head = flags & Flag.orientation ? next : -1;
  if (head >= 0) next += HEAD_SIZE;
  const followers = next;
  next += 1;
  for (let i = values[followers]; i > 0; --i) next += 2 + lawSize(values, next + 2);
  const uncoordinated = flags & Flag.apart ? next : -1;
  if (uncoordinated >= 0) next += 1;
  const superimposed = flags & Flag.beside ? { at: next + 2, flags: values[next], duration_s: values[next + 1] } : null;
  return { lead, arc, head, followers, uncoordinated, superimposed };
}

const zeros = (count: number): JointState => ({
  position: new Float64Array(count),
  velocity: new Float64Array(count),
  acceleration: new Float64Array(count),
});

/** Sets `out` to the joints at the end of the segment, with those of a superimposed motion added. */
function setEnd(records: Records, part: SegmentRecord, superimposed: SegmentRecord | null, out: Float64Array): void {
  const { values, joints } = records;
  for (let j = 0; j < joints; ++j) out[j] = values[part.at + joints + j];
  if (!superimposed) return;
  for (let j = 0; j < joints; ++j) out[j] += values[superimposed.at + joints + j] - values[superimposed.at + j];
}

function setLinear({ values, joints }: Records, { at }: SegmentRecord, lead: LawState, scale: number, out: JointState): void {
  for (let j = 0; j < joints; ++j) {
    const start = values[at + j];
    const way = values[at + joints + j] - start;
    out.position[j] = start + lead.s * scale * way;
    out.velocity[j] = lead.v * scale * way;
    out.acceleration[j] = lead.a * scale * way;
  }
}

function setArc(values: Float64Array, arc: number, lead: LawState, out: JointState): void {
  const point = arcAt(values, arc, lead.s, lead.v, lead.a);
  for (let i = 0; i < 3; ++i) {
    const joint = values[arc + i];
    if (joint < 0) continue;
    out.position[joint] = point.position[i];
    out.velocity[joint] = point.velocity[i];
    out.acceleration[joint] = point.acceleration[i];
  }
}

function setOrientationArc(values: Float64Array, head: number, lead: LawState, scale: number, out: JointState): void {
  const rate = scale * headLength_rad(values, head);
  const speed = lead.v * rate;
  const point = headAt(values, head, lead.s * rate);
  for (const [joint, [angle, first, second]] of [
    [point.turnJoint, point.turn],
    [point.tiltJoint, point.tilt],
  ] as [number, number[]][]) {
    out.position[joint] = angle;
    out.velocity[joint] = first * speed;
    out.acceleration[joint] = first * lead.a * rate + second * speed * speed;
  }
}

function setFollowers(records: Records, part: SegmentRecord, layout: Layout, t_s: number, out: JointState): void {
  const { values } = records;
  let next = layout.followers + 1;
  for (let i = values[layout.followers]; i > 0; --i) {
    const joint = values[next];
    const sign = values[next + 1];
    const own = lawState(values, next + 2, layout.uncoordinated >= 0, t_s);
    out.position[joint] = values[part.at + joint] + sign * own.s;
    out.velocity[joint] = sign * own.v;
    out.acceleration[joint] = sign * own.a;
    next += 2 + lawSize(values, next + 2);
  }
}

function addSuperimposed(records: Records, superimposed: SegmentRecord, t_s: number, out: JointState): void {
  const other = jointsAt(records, superimposed, t_s);
  for (let j = 0; j < records.joints; ++j) {
    out.position[j] += other.position[j] - records.values[superimposed.at + j];
    out.velocity[j] += other.velocity[j];
    out.acceleration[j] += other.acceleration[j];
  }
}

/** Returns the state of the joints `t_s` after the start of a segment; exact at both ends. */
export function jointsAt(records: Records, part: SegmentRecord, t_s: number): JointState {
  const { values, joints } = records;
  const layout = recordLayout(records, part);
  const lead = lawState(values, layout.lead, layout.uncoordinated >= 0, t_s);
  const length = lawLength(values, layout.lead);
  const scale = length > 0 ? 1 / length : 0;
  const out = zeros(joints);
  setLinear(records, part, lead, scale, out);
  if (layout.arc >= 0) setArc(values, layout.arc, lead, out);
  if (layout.head >= 0) setOrientationArc(values, layout.head, lead, scale, out);
  setFollowers(records, part, layout, t_s, out);
  if (layout.superimposed) addSuperimposed(records, layout.superimposed, t_s, out);
  if (t_s >= part.duration_s) setEnd(records, part, layout.superimposed, out.position);
  if (t_s <= 0 && part.duration_s > 0) for (let j = 0; j < joints; ++j) out.position[j] = values[part.at + j];
  return out;
}

/**
 * Returns the speed of the tool along its path (mm/s): `length_mm` is the segment's, `positionJoints` the
 * joints of X, Y and Z.
 */
export function pathSpeed(records: Records, part: SegmentRecord, t_s: number, length_mm: number, positionJoints: number[]): number {
  const { values } = records;
  const layout = recordLayout(records, part);
  if (!layout.superimposed && layout.uncoordinated < 0) {
    const length = lawLength(values, layout.lead);
    return length > 0 ? (lawAt(values, layout.lead, t_s).v * length_mm) / length : 0;
  }
  const { velocity } = jointsAt(records, part, t_s);
  const carries = (joint: number) =>
    layout.uncoordinated >= 0 ? ((values[layout.uncoordinated] >>> joint) & 1) !== 0 : positionJoints.includes(joint);
  return Math.sqrt(velocity.reduce((square, v, joint) => (carries(joint) ? square + v * v : square), 0));
}

/** Returns the position of the leading law in `values`. */
export const pathLawOffset = (records: Records, at: number): number => at + 2 * records.joints;

/** Returns the acceleration of the tool along its path (mm/s2); arguments as of pathSpeed. */
export function pathAcceleration(
  records: Records,
  part: SegmentRecord,
  t_s: number,
  length_mm: number,
  positionJoints: number[],
): number {
  const { values } = records;
  const layout = recordLayout(records, part);
  if (!layout.superimposed && layout.uncoordinated < 0) {
    const length = lawLength(values, layout.lead);
    return length > 0 ? (lawAt(values, layout.lead, t_s).a * length_mm) / length : 0;
  }
  const { velocity, acceleration } = jointsAt(records, part, t_s);
  let [along, speed2, size2] = [0, 0, 0];
  for (let joint = 0; joint < records.joints; ++joint) {
    const carries = layout.uncoordinated >= 0 ? (values[layout.uncoordinated] >>> joint) & 1 : positionJoints.includes(joint);
    if (!carries) continue;
    along += velocity[joint] * acceleration[joint];
    speed2 += velocity[joint] ** 2;
    size2 += acceleration[joint] ** 2;
  }
  return speed2 > 0 ? along / Math.sqrt(speed2) : Math.sqrt(size2);
}

/** True if all joints move in proportion to the leading law. */
export function isProportional(records: Records, part: SegmentRecord): boolean {
  if (part.flags & (Flag.arc | Flag.orientation | Flag.beside | Flag.apart)) return false;
  const lead = pathLawOffset(records, part.at);
  return records.values[lead + lawSize(records.values, lead)] === 0;
}

/** Returns the instants within a segment at which the law of one of its motions changes, unsorted. */
export function lawBreaks_s(records: Records, part: SegmentRecord): number[] {
  const { values } = records;
  const layout = recordLayout(records, part);
  const breaks_s = layout.superimposed ? lawBreaks_s(records, layout.superimposed) : [];
  addBreaks_s(values, layout.lead, breaks_s);
  let next = layout.followers + 1;
  for (let i = values[layout.followers]; i > 0; --i) {
    addBreaks_s(values, next + 2, breaks_s);
    if (layout.uncoordinated >= 0) breaks_s.push(lawDuration_s(values, next + 2));
    next += 2 + lawSize(values, next + 2);
  }
  if (layout.uncoordinated >= 0) breaks_s.push(lawDuration_s(values, layout.lead));
  return breaks_s;
}

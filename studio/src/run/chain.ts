// Kinematic chain from the machine's joints to the poses of its links, and the frames of a cell.

import { Matrix4, Quaternion, Vector3 } from "three";
import type { Axis, Branch, UniformMotion, Scene } from "./scene";

export const RAD_PER_DEG = Math.PI / 180;

export const axisValue = (axis: Axis, joint: number): number => axis.zero + (axis.rotary ? joint / RAD_PER_DEG : joint);
export const jointValue = (axis: Axis, value: number): number =>
  (value - axis.zero) * (axis.rotary ? RAD_PER_DEG : 1);

export const matrixOf = (values: number[]): Matrix4 => new Matrix4().fromArray(values);

interface ChainLink {
  joint: number;
  rotary: boolean;
  before: Matrix4;
  after: Matrix4;
}

interface ChainBranch {
  base: Matrix4;
  links: ChainLink[];
  end: Matrix4;
}

const toChainBranch = (branch: Branch): ChainBranch => ({
  base: matrixOf(branch.base),
  links: branch.links.map((link) => ({ ...link, before: matrixOf(link.before), after: matrixOf(link.after) })),
  end: matrixOf(branch.end),
});

/** Poses of all frames at an instant, in the world (mm). */
export interface LinkPoses {
  /** Number 0 is the machine's world, number i the link that joint i - 1 moves. */
  links: Matrix4[];
  /** Frame of each joint, which moves along or about its Z. */
  joints: Matrix4[];
  /** Tool centre point, without a tool's own offset. */
  tool: Matrix4;
  /** Frame of the drawn path. */
  work: Matrix4;
  /** Frames of the cell, in the order of Scene.frames. */
  frames: Matrix4[];
}

export class Chain {
  /** Machine's world in that of all robots. */
  private readonly world: Matrix4;
  private readonly toolSide: ChainBranch;
  private readonly workSide: ChainBranch;
  /** Drifts of each frame in the order of time; from the start of one, earlier ones do not count. */
  private readonly drifts = new Map<number, UniformMotion[]>();
  private readonly base: number;

  constructor(readonly scene: Scene) {
    this.world = matrixOf(scene.base);
    this.toolSide = toChainBranch(scene.tool_side);
    this.workSide = toChainBranch(scene.work_side);
    this.base = scene.frames?.findIndex((frame) => "link" in frame && frame.name === "base") ?? -1;
    for (const uniformMotion of scene.drifts ?? []) {
      const known = this.drifts.get(uniformMotion.frame) ?? [];
      while (known.length > 0 && known[known.length - 1].from_s >= uniformMotion.from_s) known.pop();
      known.push(uniformMotion);
      this.drifts.set(uniformMotion.frame, known);
    }
  }

  /** Returns all poses for `joints` in mm and rad, at a time of the run. */
  linkPoses(joints: ArrayLike<number>, t_s: number): LinkPoses {
    const count = this.scene.axes.length;
    const linkPoses: LinkPoses = {
      links: Array.from({ length: count + 1 }, () => this.world.clone()),
      joints: Array.from({ length: count }, () => new Matrix4()),
      tool: new Matrix4(),
      work: new Matrix4(),
      frames: [],
    };
    const shift = this.shiftOfBase(t_s);
    linkPoses.tool = follow(this.toolSide, joints, shift, linkPoses);
    const carriesWork = this.workSide.links.length > 0;
    linkPoses.work = follow(this.workSide, joints, carriesWork ? shift : null, linkPoses);
    this.computeFramePoses(linkPoses, t_s);
    return linkPoses;
  }

  /** True if frames move without the joints. */
  get drifting(): boolean {
    return this.drifts.size > 0;
  }

  private uniformMotionAt(frame: number, t_s: number): UniformMotion | undefined {
    return this.drifts.get(frame)?.findLast((uniformMotion) => uniformMotion.from_s <= t_s);
  }

  private shiftOfBase(t_s: number): Matrix4 | null {
    const uniformMotion = this.uniformMotionAt(this.base, t_s);
    return uniformMotion ? poseAt(uniformMotion, t_s).multiply(this.toolSide.base.clone().invert()) : null;
  }

  private computeFramePoses(linkPoses: LinkPoses, t_s: number): void {
    this.scene.frames?.forEach((frame, i) => {
      if ("link" in frame) {
        const moved = i === this.base && this.uniformMotionAt(i, t_s);
        const pose = moved
          ? poseAt(moved, t_s).premultiply(this.world)
          : linkPoses.links[frame.link].clone().multiply(matrixOf(frame.in_link));
        linkPoses.frames.push(pose);
      } else {
        const uniformMotion = this.uniformMotionAt(i, t_s);
        const inParent = uniformMotion ? poseAt(uniformMotion, t_s) : matrixOf(frame.in_parent);
        linkPoses.frames.push(linkPoses.frames[frame.parent].clone().multiply(inParent));
      }
    });
  }
}

function follow(branch: ChainBranch, joints: ArrayLike<number>, shift: Matrix4 | null, linkPoses: LinkPoses): Matrix4 {
  const at = branch.base.clone();
  if (shift) at.premultiply(shift);
  at.premultiply(linkPoses.links[0]);
  const motion = new Matrix4();
  for (const link of branch.links) {
    at.multiply(link.before);
    linkPoses.joints[link.joint].copy(at);
    const value = joints[link.joint];
    at.multiply(link.rotary ? motion.makeRotationZ(value) : motion.makeTranslation(0, 0, value)).multiply(link.after);
    linkPoses.links[link.joint + 1].copy(at);
  }
  return at.multiply(branch.end);
}

/**
 * Returns the frame of a drift in its parent: the origin moves straight, the rotation is about an axis
 * through it.
 */
function poseAt(uniformMotion: UniformMotion, t_s: number): Matrix4 {
  const elapsed_s = t_s - uniformMotion.from_s;
  const pose = matrixOf(uniformMotion.pose);
  const [position, turn, scale] = [new Vector3(), new Quaternion(), new Vector3()];
  pose.decompose(position, turn, scale);
  position.addScaledVector(new Vector3(...uniformMotion.velocity_mm_s), elapsed_s);
  const spin = new Vector3(...uniformMotion.spin_rad_s);
  const rate = spin.length();
  if (rate > 0) turn.premultiply(new Quaternion().setFromAxisAngle(spin.divideScalar(rate), rate * elapsed_s));
  return new Matrix4().compose(position, turn, scale);
}

// Joints as moved by hand, in place of those of the run.

import { Vector3, type Matrix4 } from "three";
import { shownRobot } from "../../core/display_state";
import type { Store } from "../../core/store";
import { axisValue, jointValue } from "../../run/chain";
import { toolInWork } from "../../run/path/tool_direction";
import type { Robot } from "../../run/run";
import type { Axis } from "../../run/scene";

/** Returns the lowest and highest value of an axis, mm or deg. */
export const axisRange = ({ min, max }: Axis): [number, number] => [min ?? -Infinity, max ?? Infinity];
export const clamped = (value: number, axis: Axis): number => Math.min(Math.max(value, axisRange(axis)[0]), axisRange(axis)[1]);

export class JogState {
  /** Joints kept while the form is not visible. */
  private kept: ArrayLike<number> | null = null;
  /** Machine that the moved joints belong to. */
  private machine = "";
  private isVisible = false;

  constructor(private readonly store: Store) {}

  get robot(): Robot | undefined {
    return shownRobot(this.store);
  }

  get axes(): Axis[] {
    return this.robot?.scene.axes ?? [];
  }

  private fits(joints: ArrayLike<number> | null): joints is ArrayLike<number> {
    return joints !== null && joints.length === this.axes.length && joints.length > 0;
  }

  /** Called when the form becomes visible: restores the last joints, else takes those of the run. */
  begin(): void {
    this.isVisible = true;
    const now = this.store.get("jog") ?? this.kept;
    const { robot } = this;
    const machine = robot ? JSON.stringify([robot.name, robot.scene.machine, this.axes]) : "";
    const isSame = machine === this.machine;
    this.machine = machine;
    if (isSame && this.fits(now)) this.store.set("jog", now);
    else this.fromRun();
  }

  end(): void {
    this.isVisible = false;
    this.kept = this.store.get("jog");
    this.store.set("jog", null);
  }

  /** Takes the joints at the shown instant, as soon as they are loaded. */
  fromRun(): void {
    const { robot } = this;
    const t_s = this.store.get("time_s");
    const joints = robot?.joints_at(t_s);
    this.store.set("jog", joints ? Array.from(joints) : null);
    if (!robot || joints) return;
    void robot.segments.fetchNow(robot.segments.at(t_s)).then((isHere) => {
      if (isHere && this.isVisible && this.robot === robot && !this.store.get("jog")) this.fromRun();
    });
  }

  /** Returns the values of all axes, mm and deg. */
  get values(): number[] {
    const joints = this.store.get("jog");
    return this.fits(joints) ? this.axes.map((axis, i) => axisValue(axis, joints[i])) : [];
  }

  setValues(values: readonly number[]): void {
    this.store.set("jog", this.axes.map((axis, i) => jointValue(axis, values[i])));
  }

  /** Sets one axis to a value, or to the nearest end of its range. Returns true if the value was reached. */
  setValue(axis: number, value: number): boolean {
    const within = clamped(value, this.axes[axis]);
    this.setValues(this.values.map((each, i) => (i === axis ? within : each)));
    return within === value;
  }

  /**
   * Returns the vector from the tool centre point (without tool offset) to the TCP in use, in the tool frame;
   * while that is not loaded, to the first TCP.
   */
  private get tip(): Vector3 {
    const { robot } = this;
    return new Vector3(...(robot?.scene.tcps_mm[robot.tcp_at(this.store.get("time_s")) ?? 0] ?? [0, 0, 0]));
  }

  /**
   * Returns the distance from the tool centre point (without tool offset) to the TCP along the tool, as the
   * engine counts it.
   */
  get tool_mm(): number {
    return -this.tip.z;
  }

  /** Returns the frame of the TCP in that of the work, or null without a machine. */
  get frame(): Matrix4 | null {
    const [joints, { robot }] = [this.store.get("jog"), this];
    if (!robot || !this.fits(joints)) return null;
    const frame = toolInWork(robot.chain, joints, this.store.get("time_s"));
    return frame.setPosition(this.tip.applyMatrix4(frame));
  }
}

// Joint panel: joints and TCP are moved by hand, points of a path are recorded at the current pose and
// approached.

import "./teach.css";
import { Quaternion, Vector3 } from "three";
import { Debounced } from "../../core/debounced";
import { element } from "../../core/dom";
import type { Session } from "../../core/session";
import type { Store } from "../../core/store";
import type { Point } from "../../run/path/path_file";
import type { State } from "../../run/path/path_traversal";
import { axisValue } from "../../run/chain";
import { jointsWith, toRpy } from "../../run/path/tool_direction";
import { texts } from "../../texts";
import type { PanelForm } from "../form";
import { numberText } from "../paths/fields";
import { JogState, axisRange } from "./jog_state";
import { JointRow } from "./joint_row";
import { requestPose, type Pose, type PoseRequest } from "./pose";
import { PointRecorder } from "./point_recorder";
import { StepSizes } from "./steps";
import { TcpPad } from "./tcp_pad";

const words = texts.teach;
const CHECK_DELAY_MS = 150;
/** With so many rotary axes the rotation of the tool about its own axis can be set. */
const MIN_REDUNDANT_AXES = 3;

class TeachPanel {
  readonly element: HTMLElement;
  private readonly state: JogState;
  private readonly none = element("p", { class: "note" }, words.nothing);
  private readonly body: HTMLElement;
  private readonly steps = new StepSizes();
  private readonly joints = element("div", { class: "joints" });
  private rows: JointRow[] = [];
  private readonly pad: TcpPad;
  private readonly pointRecorder: PointRecorder;
  private readonly said = element("p", { class: "said", role: "status" });
  private readonly checking = new Debounced(() => void this.check());
  private isVisible = false;
  /** Whether that is what is said. */
  private touches = false;

  constructor(
    private readonly store: Store,
    private readonly session: Session,
  ) {
    this.state = new JogState(store);
    this.pad = new TcpPad({
      move: (axis, sense) => this.moveTcp(axis, sense),
      turn: (axis, sense) => this.turnTool(axis, sense),
    });
    this.pointRecorder = new PointRecorder(store, session, this.state, {
      goTo: (point, state) => void this.goTo(point, state),
      say: (sentence) => this.say(sentence),
    });
    const fromRun = element("button", { type: "button", title: words.fromRunTitle, onclick: () => this.state.fromRun() }, words.fromRun);
    const head = element("div", { class: "head" }, this.steps.element, fromRun);
    this.body = element("div", { class: "teach-body" }, head, this.joints, this.pad.element, this.said, this.pointRecorder.element);
    this.element = element("div", { class: "teach" }, this.none, this.body);
    store.watch(["run", "robot"], () => this.updateRobot());
    store.watch(["jog", "units"], () => this.show());
  }

  onDisplayed(): void {
    this.isVisible = true;
    this.store.set("showPath", true);
    this.state.begin();
    this.show();
  }

  onHidden(): void {
    this.isVisible = false;
    this.state.end();
    this.store.set("showPath", false);
  }

  private say(sentence: string, isBad = false): void {
    this.said.textContent = sentence;
    this.said.classList.toggle("fault", isBad);
  }

  /** Another machine has other joints. */
  private updateRobot(): void {
    const { axes } = this.state;
    const same = axes.length === this.rows.length && axes.every((axis, i) => JSON.stringify(axis) === JSON.stringify(this.rows[i].axis));
    if (!same) {
      this.rows = axes.map((axis, i) => new JointRow(axis, { set: (value) => this.set(i, value), step: (sense) => this.step(i, sense) }));
      this.joints.replaceChildren(...this.rows.map((row) => row.element));
      this.say("");
    }
    if (this.isVisible) this.state.begin();
    this.show();
  }

  private show(): void {
    const { store, state, rows } = this;
    const units = store.get("units");
    const frame = state.frame;
    this.none.hidden = state.axes.length > 0;
    this.body.hidden = state.axes.length === 0;
    this.steps.show(units);
    if (!frame || rows.length === 0) return;
    state.values.forEach((value, i) => rows[i].show(value, units));
    const isSingleRobot = (store.get("run")?.robots.length ?? 0) === 1;
    this.pad.show(frame, units, isSingleRobot && this.session.canRun, state.axes.some(({ rotary }) => rotary));
    if (this.isVisible && isSingleRobot) this.checking.after(CHECK_DELAY_MS);
  }

  private set(axis: number, value: number): void {
    const { letter, rotary } = this.state.axes[axis];
    const isWithin = this.state.setValue(axis, value);
    const [low, high] = axisRange(this.state.axes[axis]);
    const end = numberText(value < low ? low : high, rotary ? "angle" : "length", this.store.get("units"));
    this.say(isWithin ? "" : words.limit(letter, end), !isWithin);
  }

  private step(axis: number, sense: 1 | -1): void {
    // A held button continues until its release, even if the joints have disappeared meanwhile.
    if (this.state.values.length === 0) return;
    const by = this.state.axes[axis].rotary ? this.steps.step_deg : this.steps.step_mm;
    this.set(axis, this.state.values[axis] + sense * by);
  }

  /**
   * Returns the engine's result for the current pose; null if the machine has changed, has moved or is not
   * shown any more.
   */
  private async ask(requested: PoseRequest): Promise<Pose | string | null> {
    const { robot } = this.state;
    const jog = this.store.get("jog");
    const pose = await requestPose(this.session, requested, this.state.tool_mm);
    if (!this.isVisible) return null;
    return this.state.robot === robot && this.store.get("jog") === jog ? pose : null;
  }

  /** Checks for contacts at the current pose. */
  private async check(): Promise<void> {
    const { values } = this.state;
    if (!this.isVisible || values.length === 0) return;
    const pose = await this.ask({ joints: values });
    if (pose === null || typeof pose === "string") return;
    const touches = pose.collisions.length > 0;
    if (touches) this.say(words.touching(pose.collisions.map((pair) => pair.join(" – ")).join(", ")), true);
    else if (this.touches) this.say("");
    this.touches = touches;
  }

  /**
   * Moves to the joints that the engine returns for the TCP pose; if it is not possible, a message says why,
   * and nothing moves.
   */
  private async moveToPose(requested: PoseRequest): Promise<void> {
    const { robot } = this.state;
    const pose = await this.ask(requested);
    if (pose === null) {
      if (this.isVisible && this.state.robot !== robot) this.say(words.runWasReplaced, true);
      return;
    }
    if (typeof pose === "string") return this.say(words.unreachable(pose), true);
    const beyond = this.state.axes.filter((_, i) => pose.beyond[i] !== 0).map(({ letter }) => letter);
    if (beyond.length > 0) return this.say(words.beyond(beyond.join(", ")), true);
    this.say("");
    this.state.setValues(pose.joints);
  }

  private async moveTcp(axis: number, sense: 1 | -1): Promise<void> {
    const { frame, values } = this.state;
    if (!frame) return;
    const tip = new Vector3().setFromMatrixPosition(frame);
    tip.setComponent(axis, tip.getComponent(axis) + sense * this.steps.step_mm);
    await this.moveToPose({ tip_mm: tip.toArray(), near: values });
  }

  private async turnTool(axis: number, sense: 1 | -1): Promise<void> {
    const { frame, values, axes } = this.state;
    if (!frame) return;
    const tip_mm = new Vector3().setFromMatrixPosition(frame).toArray();
    const about = new Vector3().setComponent(axis, 1);
    const turn = new Quaternion().setFromAxisAngle(about, (sense * this.steps.step_deg * Math.PI) / 180);
    const isFree = axes.filter(({ rotary }) => rotary).length >= MIN_REDUNDANT_AXES;
    if (isFree) {
      const rotation = turn.multiply(new Quaternion().setFromRotationMatrix(frame));
      await this.moveToPose({ tip_mm, rpy_deg: toRpy(rotation), near: values });
      return;
    }
    const tool_axis = new Vector3().setFromMatrixColumn(frame, 2).applyQuaternion(turn).toArray();
    await this.moveToPose({ tip_mm, tool_axis, near: values });
  }

  private async goTo({ position_mm }: Point, { tool_axis, rpy_deg, rotary_deg }: State): Promise<void> {
    const { axes, values } = this.state;
    const joints = this.store.get("jog");
    if (!joints) return;
    const near = rotary_deg ? jointsWith(axes, rotary_deg, joints).map((joint, i) => axisValue(axes[i], joint)) : values;
    const orientation = tool_axis ? { tool_axis } : rpy_deg ? { rpy_deg } : {};
    await this.moveToPose({ tip_mm: position_mm, ...orientation, near });
  }
}

export function createTeach(store: Store, session: Session): PanelForm {
  return new TeachPanel(store, session);
}

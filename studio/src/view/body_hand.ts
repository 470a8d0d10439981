// Handle of a body, or of any object requested in the store: arrows move it, rings rotate it, along and about
// the axes of its parent frame.

import { Matrix4, Scene, Vector2, Vector3, type WebGLRenderer } from "three";
import type { Handle as Held } from "../core/store";
import type { Grabbed } from "./gestures";
import { gripAt, Pull, type Grip, type Stand } from "./hand_path/grips";
import { Handle } from "./hand_path/handle";
import type { Hold, HoldPlace } from "./holds";
import type { Palette } from "./theme";

export class BodyHand implements Hold {
  private readonly scene = new Scene();
  private readonly handle = new Handle();
  private grip: Grip | null = null;
  /** Pose during a drag. */
  private pulled: Matrix4 | null = null;

  constructor(private readonly on: HoldPlace) {
    this.scene.add(this.handle.group);
    for (const key of ["handle", "run"] as const) on.store.on(key, () => this.carry());
  }

  recolour(colours: Palette): void {
    this.handle.recolour(colours);
  }

  private get shown(): Held | null {
    return this.on.store.get("handle");
  }

  private get pose(): Matrix4 {
    return this.pulled ?? new Matrix4().fromArray(this.shown!.pose);
  }

  private stand(): Stand | null {
    if (!this.shown) return null;
    const work = new Matrix4().fromArray(this.shown.parent);
    const at = new Vector3().setFromMatrixPosition(this.pose);
    const { rig, size } = this.on;
    return { work, at, rig, width_px: size.width_px, height_px: size.height_px };
  }

  /** Shows bodies at the handle, even before a run has them there. */
  private carry(): void {
    const { shown } = this;
    const { stage, store } = this.on;
    for (const { bodies } of stage.machines) bodies.carry(-1, null);
    const machine = stage.machines[store.get("robot")];
    const place = shown && machine?.at(store.get("time_s")).places.frames[shown.frame];
    if (shown && place) machine.bodies.carry(shown.frame, new Matrix4().fromArray(shown.parent).multiply(this.pose).multiply(place.clone().invert()));
    this.on.changed();
  }

  draw(renderer: WebGLRenderer): void {
    const stand = this.stand();
    if (!stand) return;
    this.handle.place(stand, null, this.grip, true);
    renderer.resetState();
    renderer.render(this.scene, this.on.rig.camera);
  }

  hover(x_px: number, y_px: number): "grab" | "" {
    const stand = this.stand();
    const grip = stand && gripAt(stand, x_px, y_px, true);
    if (grip?.kind !== this.grip?.kind || grip?.axis !== this.grip?.axis) {
      this.grip = grip;
      this.on.changed();
    }
    return grip ? "grab" : "";
  }

  /** Grabs the handle if it is under the pointer; a drag is shown at once, and reported on release. */
  grab(x_px: number, y_px: number): Grabbed | null {
    const { shown } = this;
    const stand = this.stand();
    const grip = stand && gripAt(stand, x_px, y_px, true);
    if (!shown || !stand || !grip) return null;
    const pull = new Pull(stand, grip, new Vector2(x_px, y_px));
    const before = this.pose;
    this.grip = grip;
    this.pulled = before.clone();
    const end = () => {
      this.pulled = null;
      this.grip = null;
    };
    return {
      drag: (x, y) => {
        if (!this.pulled) return;
        this.pulled = grip.kind === "turn" ? turned(before, pull, x, y) : shifted(before, pull, x, y);
        this.carry();
      },
      drop: () => {
        const { pulled } = this;
        end();
        if (pulled) shown.moved(pulled.toArray());
      },
      cancel: () => {
        end();
        this.carry();
      },
    };
  }

  escape(): boolean {
    if (!this.pulled) return false;
    this.pulled = null;
    this.carry();
    return true;
  }
}

const shifted = (before: Matrix4, pull: Pull, x: number, y: number): Matrix4 =>
  before.clone().setPosition(new Vector3().setFromMatrixPosition(before).add(pull.shift(x, y)));

const turned = (before: Matrix4, pull: Pull, x: number, y: number): Matrix4 =>
  new Matrix4().makeRotationFromQuaternion(pull.turn(x, y)).multiply(before.clone().setPosition(0, 0, 0)).copyPosition(before);

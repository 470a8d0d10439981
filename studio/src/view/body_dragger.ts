// Handle of a body, or of any object requested in the store: arrows move it, rings rotate it, along and about
// the axes of its parent frame.

import { Matrix4, Scene, Vector2, Vector3, type WebGLRenderer } from "three";
import type { Handle as Held } from "../core/store";
import type { ActiveGrab } from "./gestures";
import { Handle } from "./path_editing/handle";
import { gripAt, HandleDrag, type HandleGrip, type HandleContext } from "./path_editing/handle_grips";
import type { Draggable, DraggableContext } from "./draggables";
import type { Palette } from "./theme";

export class BodyDragger implements Draggable {
  private readonly scene = new Scene();
  private readonly handle = new Handle();
  private grip: HandleGrip | null = null;
  /** Pose during a drag. */
  private draggedPose: Matrix4 | null = null;

  constructor(private readonly on: DraggableContext) {
    this.scene.add(this.handle.group);
    for (const key of ["handle", "run"] as const) on.store.on(key, () => this.carry());
  }

  recolour(colours: Palette): void {
    this.handle.recolour(colours);
  }

  private get displayed(): Held | null {
    return this.on.store.get("handle");
  }

  private get pose(): Matrix4 {
    return this.draggedPose ?? new Matrix4().fromArray(this.displayed!.pose);
  }

  private handleContext(): HandleContext | null {
    if (!this.displayed) return null;
    const work = new Matrix4().fromArray(this.displayed.parent);
    const at = new Vector3().setFromMatrixPosition(this.pose);
    const { rig, size } = this.on;
    return { work, at, rig, width_px: size.width_px, height_px: size.height_px };
  }

  /** Shows bodies at the handle, even before a run has them there. */
  private carry(): void {
    const { displayed } = this;
    const { runScene, store } = this.on;
    for (const { bodies } of runScene.machines) bodies.carry(-1, null);
    const machine = runScene.machines[store.get("robot")];
    const place = displayed && machine?.at(store.get("time_s")).linkPoses.frames[displayed.frame];
    if (displayed && place) machine.bodies.carry(displayed.frame, new Matrix4().fromArray(displayed.parent).multiply(this.pose).multiply(place.clone().invert()));
    this.on.changed();
  }

  draw(renderer: WebGLRenderer): void {
    const handleContext = this.handleContext();
    if (!handleContext) return;
    this.handle.place(handleContext, null, this.grip, true);
    renderer.resetState();
    renderer.render(this.scene, this.on.rig.camera);
  }

  hover(x_px: number, y_px: number): "grab" | "" {
    const handleContext = this.handleContext();
    const grip = handleContext && gripAt(handleContext, x_px, y_px, true);
    if (grip?.kind !== this.grip?.kind || grip?.axis !== this.grip?.axis) {
      this.grip = grip;
      this.on.changed();
    }
    return grip ? "grab" : "";
  }

  /** Grabs the handle if it is under the pointer; a drag is shown at once, and reported on release. */
  grab(x_px: number, y_px: number): ActiveGrab | null {
    const { displayed } = this;
    const handleContext = this.handleContext();
    const grip = handleContext && gripAt(handleContext, x_px, y_px, true);
    if (!displayed || !handleContext || !grip) return null;
    const handleDrag = new HandleDrag(handleContext, grip, new Vector2(x_px, y_px));
    const before = this.pose;
    this.grip = grip;
    this.draggedPose = before.clone();
    const end = () => {
      this.draggedPose = null;
      this.grip = null;
    };
    return {
      drag: (x, y) => {
        if (!this.draggedPose) return;
        this.draggedPose = grip.kind === "turn" ? turned(before, handleDrag, x, y) : shifted(before, handleDrag, x, y);
        this.carry();
      },
      drop: () => {
        const { draggedPose } = this;
        end();
        if (draggedPose) displayed.moved(draggedPose.toArray());
      },
      cancel: () => {
        end();
        this.carry();
      },
    };
  }

  cancelDrag(): boolean {
    if (!this.draggedPose) return false;
    this.draggedPose = null;
    this.carry();
    return true;
  }
}

const shifted = (before: Matrix4, handleDrag: HandleDrag, x: number, y: number): Matrix4 =>
  before.clone().setPosition(new Vector3().setFromMatrixPosition(before).add(handleDrag.shift(x, y)));

const turned = (before: Matrix4, handleDrag: HandleDrag, x: number, y: number): Matrix4 =>
  new Matrix4().makeRotationFromQuaternion(handleDrag.turn(x, y)).multiply(before.clone().setPosition(0, 0, 0)).copyPosition(before);

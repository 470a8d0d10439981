// Objects of the picture that can be grabbed or selected; a page that only shows a finished run has none.

import type { Box3, Matrix4, WebGLRenderer } from "three";
import type { Session } from "../core/session";
import type { Store } from "../core/store";
import type { CameraRig } from "./camera";
import type { ActiveGrab } from "./gestures";
import type { RunScene } from "./run_scene";
import type { Palette } from "./theme";

/** Size of the picture, in pixels of the page. */
export interface Size {
  width_px: number;
  height_px: number;
}

/**
 * Object that can be grabbed. Positions are px from the left and from above; `work` is the shown work frame.
 */
export interface Draggable {
  recolour(colours: Palette): void;
  /** Returns the box of it that must be visible, in the world. */
  box?(work: Matrix4): Box3;
  /** Draws over the previous contents. */
  draw(renderer: WebGLRenderer, work: Matrix4): void;
  /** Called at standstill of the camera: updates marks for the view. */
  layOut?(): void;
  /** Returns the action of the pointer there. */
  hover(x_px: number, y_px: number): "grab" | "pointer" | "";
  /** Returns null if nothing can be grabbed. */
  grab(x_px: number, y_px: number): ActiveGrab | null;
  /** Whether something was chosen there. */
  click?(x_px: number, y_px: number): boolean;
  /** Reverts a drag; returns true if one was active. */
  cancelDrag(): boolean;
}

/** Environment of holds, and their callbacks. */
export interface DraggableContext {
  store: Store;
  session: Session;
  runScene: RunScene;
  rig: CameraRig;
  size: Size;
  /** Requests a redraw. */
  changed(): void;
  /** As changed(), and points have moved on the screen. */
  moved(): void;
  /** Called if another path is shown, and is not fully visible. */
  onOutOfView(): void;
}

/** Creates the holds; those in front are queried first. */
export type CreateDraggables = (place: DraggableContext) => Draggable[];

export const noDraggables: CreateDraggables = () => [];

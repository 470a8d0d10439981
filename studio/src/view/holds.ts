// What a person takes hold of in the picture, or chooses there; a page to look at a finished run in has nothing of the kind.

import type { Box3, Matrix4, WebGLRenderer } from "three";
import type { Session } from "../core/session";
import type { Store } from "../core/store";
import type { CameraRig } from "./camera";
import type { Grabbed } from "./gestures";
import type { Stage } from "./stage";
import type { Palette } from "./theme";

/** Of the picture, in pixels of the page. */
export interface Size {
  width_px: number;
  height_px: number;
}

/** Places are px from the left and from above; `work` is the frame of the work that is shown. */
export interface Hold {
  recolour(colours: Palette): void;
  /** What has to be seen of it, in the world. */
  box?(work: Matrix4): Box3;
  /** Draws above what has been drawn. */
  draw(renderer: WebGLRenderer, work: Matrix4): void;
  /** The eye rests: marks are laid for what it sees. */
  lay?(): void;
  /** What the pointer would do there. */
  hover(x_px: number, y_px: number): "grab" | "pointer" | "";
  /** null: there is nothing to hold. */
  grab(x_px: number, y_px: number): Grabbed | null;
  /** Whether something was chosen there. */
  click?(x_px: number, y_px: number): boolean;
  /** Puts back what is pulled; whether something was. */
  escape(): boolean;
}

/** Where holds are, and whom they tell. */
export interface HoldPlace {
  store: Store;
  session: Session;
  stage: Stage;
  rig: CameraRig;
  size: Size;
  /** Something is to be drawn anew. */
  changed(): void;
  /** As changed(), and points stand elsewhere on the screen. */
  moved(): void;
  /** Another path is shown, and not all of it is seen. */
  outOfSight(): void;
}

/** Those in front are asked first. */
export type CreateHolds = (place: HoldPlace) => Hold[];

export const noHolds: CreateHolds = () => [];

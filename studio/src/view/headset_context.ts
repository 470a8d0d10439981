// Entry from the page into a headset; a page that only shows a finished run has none.

import type { AnimationFrames } from "../core/animation_frames";
import type { Store } from "../core/store";
import type { View } from "./view";

export interface HeadsetContext {
  view: View;
  store: Store;
  frames: AnimationFrames;
  toolbar: HTMLElement;
}

export type CreateHeadset = (place: HeadsetContext) => Promise<void>;

export const noHeadset: CreateHeadset = async () => undefined;

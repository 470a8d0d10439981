// What leads out of the page into a headset; a page to look at a finished run in has nothing of the kind.

import type { Frames } from "../core/frames";
import type { Store } from "../core/store";
import type { View } from "./view";

export interface HeadsetPlace {
  view: View;
  store: Store;
  frames: Frames;
  toolbar: HTMLElement;
}

export type CreateHeadset = (place: HeadsetPlace) => Promise<void>;

export const noHeadset: CreateHeadset = async () => undefined;

// Place of a second run on the same clock; a page that only shows a finished run has none.

import type { AnimationFrames } from "../core/animation_frames";
import type { Session } from "../core/session";
import type { Store } from "../core/store";
import type { View } from "./view";

export interface ComparisonViewContext {
  host: HTMLElement;
  view: View;
  store: Store;
  session: Session;
  frames: AnimationFrames;
}

export type CreateComparisonView = (place: ComparisonViewContext) => void;

export const noComparisonView: CreateComparisonView = () => undefined;

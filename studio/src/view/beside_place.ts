// Where a second run on the same clock finds room; a page to look at a finished run in has nothing of the kind.

import type { Frames } from "../core/frames";
import type { Session } from "../core/session";
import type { Store } from "../core/store";
import type { View } from "./view";

export interface BesidePlace {
  host: HTMLElement;
  view: View;
  store: Store;
  session: Session;
  frames: Frames;
}

export type CreateBeside = (place: BesidePlace) => void;

export const noBeside: CreateBeside = () => undefined;

// What all parts of the form work with.

import type { Session } from "../../../core/session";
import type { Store } from "../../../core/store";
import type { Edits } from "../file/edits";
import type { Model } from "../file/model";
import type { Keys } from "./keys";

export interface Context {
  store: Store;
  session: Session;
  model: Model;
  edits: Edits;
  keys: Keys;
}

/** A part of the form; drawn anew whenever the files have been read, in place. */
export interface Section {
  element: HTMLElement;
  draw(): void;
}

// Data that all parts of the form use.

import type { Session } from "../../../core/session";
import type { Store } from "../../../core/store";
import type { Edits } from "../file/edits";
import type { Model } from "../file/model";
import type { Keys } from "./key_schema";

export interface Context {
  store: Store;
  session: Session;
  model: Model;
  edits: Edits;
  keys: Keys;
}

/** Part of the form; redrawn in place whenever the files have been read. */
export interface Section {
  element: HTMLElement;
  draw(): void;
}

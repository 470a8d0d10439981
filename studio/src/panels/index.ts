// The side of the page: the results of a run.

import type { Session } from "../core/session";
import type { Store } from "../core/store";
import { createResults } from "./results";

export function createSide(host: HTMLElement, store: Store, _session: Session): void {
  createResults(host, store);
}

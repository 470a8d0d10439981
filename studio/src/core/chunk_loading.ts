// Loads the shown part of a long run if it is missing.

import type { Store } from "./store";

export function loadVisiblePart(store: Store): void {
  store.watch(["time_s", "run", "playing"], () => store.get("run")?.prefetch(store.get("time_s"), store.get("playing")));
}

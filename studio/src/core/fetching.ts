// What is shown of a long run is fetched when it is not here.

import type { Store } from "./store";

export function fetchShown(store: Store): void {
  store.watch(["time_s", "run", "playing"], () => store.get("run")?.want(store.get("time_s"), store.get("playing")));
}

// Lets the time of the run go by, `rate` seconds of it in a second.

import type { Store } from "../core/store";

export function createPlayer(store: Store): void {
  let before_ms = 0;
  let frame = 0;
  const step = (now_ms: number) => {
    if (!store.get("playing")) return;
    const end_s = store.get("run")?.end_s ?? 0;
    const t_s = store.get("time_s") + (store.get("rate") * Math.max(now_ms - before_ms, 0)) / 1000;
    before_ms = now_ms;
    store.set("time_s", Math.min(t_s, end_s));
    if (t_s >= end_s) store.set("playing", false);
    else frame = requestAnimationFrame(step);
  };
  store.on("playing", (playing) => {
    cancelAnimationFrame(frame);
    if (!playing) return;
    // At the end it begins anew.
    if (store.get("time_s") >= (store.get("run")?.end_s ?? 0)) store.set("time_s", 0);
    before_ms = performance.now();
    frame = requestAnimationFrame(step);
  });
}

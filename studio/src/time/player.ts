// Plays the run, `rate` seconds of it in a second.

import type { AnimationFrames } from "../core/animation_frames";
import { clockEnd_s } from "../core/display_state";
import type { Store } from "../core/store";

export function createPlayer(store: Store, frames: AnimationFrames): void {
  let before_ms = 0;
  let frame = 0;
  const step = (now_ms: number) => {
    if (!store.get("playing")) return;
    const end_s = clockEnd_s(store);
    const t_s = store.get("time_s") + (store.get("rate") * Math.max(now_ms - before_ms, 0)) / 1000;
    before_ms = now_ms;
    store.set("time_s", Math.min(t_s, end_s));
    if (t_s >= end_s) store.set("playing", false);
    else frame = frames.request(step);
  };
  store.on("playing", (playing) => {
    frames.cancel(frame);
    if (!playing) return;
    // Starts again at the end.
    if (store.get("time_s") >= clockEnd_s(store)) store.set("time_s", 0);
    before_ms = frames.now_ms;
    frame = frames.request(step);
  });
}

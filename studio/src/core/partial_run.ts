// Run that may be too long for the page, so its engine keeps it: its size is reported and shown during the
// run.

import { Run } from "../run/run";
import { texts } from "../texts";
import type { RunStorage } from "./engine";
import type { Store } from "./store";

/**
 * Number of segments from which it is shown. It is updated after this growth, but not sooner than after this
 * time.
 */
const MIN_SHOWN_SEGMENTS = 200_000;
const MIN_GROWTH = 1.3;
const MIN_UPDATE_MS = 1000;

/** Returns two names that no other page has, so that the shown run is kept while another one begins. */
function createStorageKeys(): string[] {
  const random = Array.from(crypto.getRandomValues(new Uint8Array(8)), (byte) => byte.toString(16).padStart(2, "0")).join("");
  return ["0", "1"].map((end) => random.slice(1) + end);
}

export class PartialRun {
  private readonly names = createStorageKeys();
  private shown_ms = 0;

  constructor(private readonly store: Store) {}

  /** Of these sources. */
  begin(sources: Map<string, string>, runStorage: RunStorage): Run {
    const { store } = this;
    const storageKey = this.names.find((name) => name !== store.get("run")?.storageKey)!;
    const run = new Run(sources, (number) => runStorage.laws(storageKey, number), storageKey);
    run.laws!.onLoaded = () => store.set("loadCount", store.get("loadCount") + 1);
    run.laws!.failed = (why) => {
      if (store.get("run") === run) store.set("notice", texts.folder.notFetched(why));
    };
    return run;
  }

  /** Shows the larger part of a run in progress. */
  show(run: Run): void {
    const { store } = this;
    const running = store.get("running");
    const count = run.robots.reduce((sum, { segments }) => sum + segments.count, 0);
    // Programs with loops report no progress by lines, so the number of segments shows it.
    if (running?.total === 0) store.set("running", { done: Math.max(running.done, count), total: 0 });
    if (!run.storageKey || count < MIN_SHOWN_SEGMENTS) return;
    // The page has memory for one long run.
    if (run.isLong && store.get("run")?.isLong) store.set("run", null);
    const [partialRun, now_ms] = [store.get("partialRun"), performance.now()];
    if (partialRun && (count < MIN_GROWTH * partialRun.count || now_ms - this.shown_ms < MIN_UPDATE_MS)) return;
    this.shown_ms = now_ms;
    store.set("partialRun", { run, count });
  }

  end(): void {
    this.store.set("partialRun", null);
  }
}

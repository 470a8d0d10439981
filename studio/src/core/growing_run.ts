// A run that may be too long for the page, which its engine keeps: how much there is of it is told, and shown, while it goes on.

import { Run } from "../run/run";
import { texts } from "../texts";
import type { Keeper } from "./engine";
import type { Store } from "./store";

/** It is shown from so many segments on, and anew when there is so much more of it, not sooner than after this time. */
const FIRST_SHOWN = 200_000;
const GROWTH = 1.3;
const GROWTH_MS = 1000;

/** Two names that no other page has, so that the run that is shown is kept while another one begins. */
function keptNames(): string[] {
  const random = Array.from(crypto.getRandomValues(new Uint8Array(8)), (byte) => byte.toString(16).padStart(2, "0")).join("");
  return ["0", "1"].map((end) => random.slice(1) + end);
}

export class GrowingRun {
  private readonly names = keptNames();
  private shown_ms = 0;

  constructor(private readonly store: Store) {}

  /** Of these sources. */
  begin(sources: Map<string, string>, keeper: Keeper): Run {
    const { store } = this;
    const keptAs = this.names.find((name) => name !== store.get("run")?.keptAs)!;
    const run = new Run(sources, (number) => keeper.laws(keptAs, number), keptAs);
    run.laws!.come = () => store.set("fetched", store.get("fetched") + 1);
    run.laws!.failed = (why) => {
      if (store.get("run") === run) store.set("notice", texts.folder.notFetched(why));
    };
    return run;
  }

  /** There is more of a run under way. */
  show(run: Run): void {
    const { store } = this;
    const running = store.get("running");
    const count = run.robots.reduce((sum, { segments }) => sum + segments.count, 0);
    // Programs of loops tell no progress by their lines: what has moved does.
    if (running?.total === 0) store.set("running", { done: Math.max(running.done, count), total: 0 });
    if (!run.keptAs || count < FIRST_SHOWN) return;
    // The page has room for one long run.
    if (run.isLong && store.get("run")?.isLong) store.set("run", null);
    const [growing, now_ms] = [store.get("growing"), performance.now()];
    if (growing && (count < GROWTH * growing.count || now_ms - this.shown_ms < GROWTH_MS)) return;
    this.shown_ms = now_ms;
    store.set("growing", { run, count });
  }

  end(): void {
    this.store.set("growing", null);
  }
}

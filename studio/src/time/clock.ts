// Shown instant, in seconds and as a clock, with the active motion.

import { kindColours } from "../core/colours";
import { element } from "../core/dom";
import { clockEnd_s, activeLine, shownRobot } from "../core/display_state";
import type { Store } from "../core/store";
import { clockText, feedText, programmedFeedText } from "../core/units";
import { texts } from "../texts";

const words = texts.time;

export function createClock(store: Store): HTMLElement {
  const seconds = element("output", { class: "seconds", title: words.seconds });
  const clock = element("span", { class: "clock", title: words.clock });
  const whole = element("span", { class: "whole-time", title: words.whole });
  const place = element("span", { class: "place" });
  const kind = element("span", { class: "kind" });
  const feed = element("span", { class: "feed", title: words.feedHint });
  const root = element("div", { class: "clock-row" }, clock, whole, seconds, place, kind, feed);

  store.watch(["time_s", "run", "comparisonRun", "robot", "units", "selection", "loadCount"], () => {
    const t_s = store.get("time_s");
    const robot = shownRobot(store);
    clock.textContent = clockText(t_s);
    whole.textContent = `/ ${clockText(clockEnd_s(store))}`;
    seconds.textContent = `${t_s.toFixed(3)} s`;
    const index = robot ? robot.segments.at(t_s) : -1;
    place.textContent = kind.textContent = feed.textContent = "";
    kind.hidden = index < 0;
    if (!robot || index < 0) return;
    const info = robot.segments.info(index);
    const speed_mm_s = robot.segments.speed_at(t_s);
    const here = activeLine(store);
    place.textContent = here ? texts.run.line(here.line) : "";
    place.title = here?.file ?? "";
    kind.hidden = info === null;
    feed.title = info ? words.feedHint : words.notHere;
    if (!info || speed_mm_s === null) return void (feed.textContent = "…");
    const units = store.get("units");
    const speed = feedText(speed_mm_s, units);
    kind.textContent = texts.run.kinds[info.kind];
    kind.style.setProperty("--colour", kindColours[info.kind]);
    const asked = info.feed_per_min > 0 ? programmedFeedText(info.feed_per_min, info.length_mm, units) : "";
    feed.textContent = info.kind === "dwell" ? "" : asked ? words.feedOf(speed, asked) : speed;
  });
  return root;
}

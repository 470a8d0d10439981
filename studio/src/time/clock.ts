// The instant that is shown, in seconds and as a clock has it, with what runs then.

import { kindColours } from "../core/colours";
import { element } from "../core/dom";
import type { Store } from "../core/store";
import { feedText } from "../core/units";
import { texts } from "../texts";
import { robotOf } from "./steps";

const words = texts.time;

/** "0:01:23.456" */
function clockText(t_s: number): string {
  const all_ms = Math.round(t_s * 1000);
  const whole = Math.floor(all_ms / 1000);
  const two = (value: number) => String(value).padStart(2, "0");
  const parts = `${Math.floor(whole / 3600)}:${two(Math.floor(whole / 60) % 60)}:${two(whole % 60)}`;
  return `${parts}.${String(all_ms % 1000).padStart(3, "0")}`;
}

export function createClock(store: Store): HTMLElement {
  const seconds = element("output", { class: "seconds", title: words.seconds });
  const clock = element("span", { class: "clock", title: words.clock });
  const whole = element("span", { class: "whole-time", title: words.whole });
  const place = element("span", { class: "place" });
  const kind = element("span", { class: "kind" });
  const feed = element("span", { class: "feed", title: words.feedHint });
  const root = element("div", { class: "clock-row" }, clock, whole, seconds, place, kind, feed);

  store.watch(["time_s", "run", "robot", "units"], () => {
    const run = store.get("run");
    const t_s = store.get("time_s");
    const robot = robotOf(store);
    clock.textContent = clockText(t_s);
    whole.textContent = `/ ${clockText(run?.end_s ?? 0)}`;
    seconds.textContent = `${t_s.toFixed(3)} s`;
    const index = robot ? robot.segments.at(t_s) : -1;
    place.textContent = kind.textContent = feed.textContent = "";
    kind.hidden = index < 0;
    if (!robot || index < 0) return;
    const info = robot.segments.info(index);
    const speed = feedText(robot.segments.speed_at(t_s), store.get("units"));
    place.textContent = words.line(info.line);
    place.title = robot.files[info.file] ?? "";
    kind.textContent = words.kinds[info.kind];
    kind.style.setProperty("--colour", kindColours[info.kind]);
    const asked = info.feed_per_min > 0 ? feedText(info.feed_per_min / 60, store.get("units")) : "";
    feed.textContent = info.kind === "dwell" ? "" : asked ? words.feedOf(speed, asked) : speed;
  });
  return root;
}

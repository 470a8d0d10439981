// Scrubber: a slider over the shown stretch of time, with marks and bands; below it the position of that
// stretch in the run.

import { element } from "../core/dom";
import { goTo } from "../core/navigation";
import { onTheme } from "../core/theme";
import type { Store } from "../core/store";
import { timeText } from "../core/units";
import type { Mark } from "../run/marks";
import { texts } from "../texts";
import { listenToDrag } from "./drag";
import { drawStrip, timePixel, type Content } from "./draw";
import { fullMarkText } from "./mark_text";
import type { TimeWindow } from "./time_window";

const words = texts.time;
const SNAP_DISTANCE_PX = 6;
const FINE_FACTOR = 0.1;
const MAX_TOOLTIP_MARKS = 4;
const WHEEL_STEP = 1 / 1000;

export interface Scrubber {
  element: HTMLElement;
  begin(content: Content | null): void;
}

export function createScrubber(store: Store, window: TimeWindow): Scrubber {
  const canvas = element("canvas", { "aria-hidden": "true" });
  const now = element("div", { class: "now" });
  const tip = element("div", { class: "tip", role: "tooltip" });
  tip.hidden = true;
  const slider = { class: "track", role: "slider", tabindex: 0, "aria-label": words.scrubber };
  const track = element("div", slider, canvas, now);
  const thumb = element("div", { class: "thumb" });
  const overview = element("div", { class: "overview", title: words.overview }, thumb);
  const root = element("div", { class: "scrubber" }, track, overview, tip);
  let content: Content | null = null;
  let frame = 0;

  const timeOf = (x: number) => window.start_s + (x / Math.max(track.clientWidth, 1)) * window.span_s;
  const pointerX = (event: MouseEvent) => event.clientX - track.getBoundingClientRect().left;
  const put = (t_s: number) => store.set("time_s", Math.min(Math.max(t_s, 0), window.total_s));

  function draw(): void {
    drawStrip(canvas, window, content);
    const total_s = Math.max(window.total_s, 1e-12);
    thumb.style.left = `${(100 * window.start_s) / total_s}%`;
    thumb.style.width = `${(100 * window.span_s) / total_s}%`;
    overview.classList.toggle("whole", window.isComplete);
    point();
  }

  const later = () => {
    cancelAnimationFrame(frame);
    frame = requestAnimationFrame(draw);
  };

  function point(): void {
    const t_s = store.get("time_s");
    now.style.transform = `translateX(${timePixel(window, track.clientWidth, t_s)}px)`;
    now.hidden = t_s < window.start_s || t_s > window.end_s;
    track.setAttribute("aria-valuemin", "0");
    track.setAttribute("aria-valuemax", String(window.total_s));
    track.setAttribute("aria-valuenow", String(t_s));
    track.setAttribute("aria-valuetext", timeText(t_s));
  }

  function near(x: number): Mark[] {
    if (!content) return [];
    const distance = (mark: Mark) => Math.abs(timePixel(window, track.clientWidth, mark.t_s) - x);
    return content.marks.filter((mark) => distance(mark) <= SNAP_DISTANCE_PX).sort((a, b) => distance(a) - distance(b));
  }

  function tell(x: number): void {
    const marks = near(x);
    const textOf = (mark: Mark) => `${timeText(mark.t_s)}  ${fullMarkText(mark, store.get("units"))}`;
    const lines = marks.slice(0, MAX_TOOLTIP_MARKS).map(textOf);
    if (marks.length > MAX_TOOLTIP_MARKS) lines.push(words.more(marks.length - MAX_TOOLTIP_MARKS));
    tip.textContent = [...lines, ...(lines.length === 0 ? [timeText(timeOf(x))] : [])].join("\n");
    tip.hidden = !content;
    const left = Math.min(Math.max(track.offsetLeft + x - tip.offsetWidth / 2, 0), root.clientWidth - tip.offsetWidth);
    tip.style.left = `${left}px`;
  }

  listenToDrag(track, {
    begin: (event) => {
      store.set("playing", false);
      const [mark] = near(pointerX(event));
      if (mark) goTo(store, mark, mark.t_s);
      else if (!event.shiftKey) put(timeOf(pointerX(event)));
    },
    move: (event, by_px) => {
      if (event.shiftKey) put(store.get("time_s") + ((FINE_FACTOR * by_px) / track.clientWidth) * window.span_s);
      else put(timeOf(pointerX(event)));
      tell(pointerX(event));
    },
  });
  listenToDrag(overview, {
    begin: (event) => {
      const rect = overview.getBoundingClientRect();
      const t_s = ((event.clientX - rect.left) / rect.width) * window.total_s;
      if (t_s < window.start_s || t_s > window.end_s) window.pan(t_s - window.start_s - window.span_s / 2);
    },
    move: (_, by_px) => window.pan((by_px / overview.clientWidth) * window.total_s),
  });
  track.addEventListener("pointermove", (event) => tell(pointerX(event)));
  track.addEventListener("pointerleave", () => (tip.hidden = true));
  track.addEventListener("dblclick", () => window.reset());
  track.addEventListener("wheel", (event) => onWheel(event, timeOf(pointerX(event))), { passive: false });
  track.addEventListener("keydown", onKey);

  function onWheel(event: WheelEvent, t_s: number): void {
    event.preventDefault();
    if (event.ctrlKey) window.zoom(t_s, Math.exp(event.deltaY / 400));
    else if (event.shiftKey) window.pan((window.span_s * (event.deltaX + event.deltaY)) / 1000);
    else put(store.get("time_s") + Math.sign(event.deltaY || event.deltaX) * WHEEL_STEP * window.span_s);
  }

  function onKey(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const t_s = store.get("time_s");
    const step_s = window.span_s / (event.shiftKey ? 1000 : 100);
    const actions: Record<string, () => void> = {
      ArrowLeft: () => put(t_s - step_s),
      ArrowDown: () => put(t_s - step_s),
      ArrowRight: () => put(t_s + step_s),
      ArrowUp: () => put(t_s + step_s),
      PageDown: () => put(t_s - 10 * step_s),
      PageUp: () => put(t_s + 10 * step_s),
      "+": () => window.zoom(t_s, 0.5),
      "=": () => window.zoom(t_s, 0.5),
      "-": () => window.zoom(t_s, 2),
      "0": () => window.reset(),
    };
    if (!actions[event.key]) return;
    event.preventDefault();
    actions[event.key]();
    window.show(store.get("time_s"));
  }

  window.on(later);
  store.on("time_s", point);
  onTheme(later);
  new ResizeObserver(later).observe(track);
  return {
    element: root,
    begin(next) {
      content = next;
      track.setAttribute("aria-disabled", String(!next));
      draw();
    },
  };
}

// Strip at the bottom: playing, stepping, the scrubber, charts over time.

import "uplot/dist/uPlot.min.css";
import "./time.css";
import { element } from "../core/dom";
import type { AnimationFrames } from "../core/animation_frames";
import type { Session } from "../core/session";
import { clockEnd_s, shownRobot } from "../core/display_state";
import type { Store } from "../core/store";
import { runMarks, type Mark } from "../run/marks";
import { texts } from "../texts";
import { createCharts } from "./charts";
import { createClock } from "./clock";
import { createKeyboard } from "./keyboard";
import { fullMarkText } from "./mark_text";
import { createPlayer } from "./player";
import { processEdges_s } from "./process";
import { createResizeHandle } from "./resize_handle";
import { createScrubber } from "./scrubber";
import { goToEnd, goToStart, stepBlock, stepMark } from "./steps";
import { TimeWindow } from "./time_window";
import { createTransport, type Actions } from "./transport";

const words = texts.time;

export function createTimePanel(host: HTMLElement, store: Store, _session: Session, frames: AnimationFrames): void {
  const window = new TimeWindow();
  let marks: Mark[] = [];
  const markText = element("div", { class: "mark-text", role: "status", "aria-live": "polite" });
  const actions: Actions = {
    play: () => store.set("playing", !store.get("playing") && store.get("run") !== null),
    start: () => goToStart(store),
    end: () => goToEnd(store),
    block: (by) => stepBlock(store, by),
    mark: (by) => {
      const mark = stepMark(store, marks, by);
      markText.textContent = mark ? fullMarkText(mark, store.get("units")) : words.noMark;
    },
  };
  const scrubber = createScrubber(store, window);
  const charts = createCharts(store, window);
  createPlayer(store, frames);
  createKeyboard({
    " ": actions.play,
    ",": () => actions.block(-1),
    ".": () => actions.block(1),
    "[": () => actions.mark(-1),
    "]": () => actions.mark(1),
    Home: actions.start,
    End: actions.end,
  });
  const bar = element("div", { class: "bar" }, createTransport(store, actions), createClock(store), markText);
  const left = element("div", { class: "left" }, createZoom(store, window), charts.chooser);
  host.append(createResizeHandle(host), bar, left, scrubber.element, charts.list);

  // The text of a mark does not apply to another instant.
  store.on("time_s", () => {
    if (markText.textContent) markText.textContent = "";
    if (!window.isComplete) window.show(store.get("time_s"));
  });
  store.watch(["run", "comparisonRun", "robot"], () => {
    const run = store.get("run");
    const robot = shownRobot(store);
    marks = run && robot ? runMarks(run, store.get("robot")) : [];
    window.begin(clockEnd_s(store));
    const content = robot && { segments: robot.segments, marks, process_s: processEdges_s(robot.segments) };
    scrubber.begin(content ?? null);
    charts.begin(marks);
    host.classList.toggle("empty", !content);
  });
}

function createZoom(store: Store, window: TimeWindow): HTMLElement {
  const button = (label: string, title: string, click: () => void) =>
    element("button", { class: "icon", title, "aria-label": title, onclick: click }, label);
  const zoom = (factor: number) => {
    const t_s = store.get("time_s");
    const inside = t_s >= window.start_s && t_s <= window.end_s;
    window.zoom(inside ? t_s : (window.start_s + window.end_s) / 2, factor);
  };
  return element(
    "div",
    { class: "zoom", role: "group", "aria-label": words.zoom },
    button("−", words.zoomOut, () => zoom(2)),
    button("+", words.zoomIn, () => zoom(0.5)),
    button("↔", words.zoomWhole, () => window.reset()),
  );
}

// Upper edge of the strip, for changing its height.

import { element } from "../core/dom";
import { texts } from "../texts";
import { listenToDrag } from "./drag";

const MIN_HEIGHT_PX = 150;
const MAX_SHARE = 0.75;
const STEP_PX = 20;

/** `strip` is in the last row of a grid. */
export function createResizeHandle(strip: HTMLElement): HTMLElement {
  const grid = strip.parentElement!;
  const grow = (by_px: number) => {
    const most_px = grid.clientHeight * MAX_SHARE;
    const height_px = Math.max(Math.min(strip.offsetHeight + by_px, most_px), MIN_HEIGHT_PX);
    grid.style.gridTemplateRows = `minmax(0, 1fr) ${height_px}px`;
  };
  const label = texts.time.grip;
  const grip = element("div", {
    class: "grip",
    role: "separator",
    tabindex: 0,
    "aria-orientation": "horizontal",
    "aria-label": label,
    title: label,
    ondblclick: () => (grid.style.gridTemplateRows = ""),
  });
  listenToDrag(grip, { move: (_event, _x_px, y_px) => grow(-y_px) });
  grip.addEventListener("keydown", (event) => {
    const by_px = { ArrowUp: STEP_PX, ArrowDown: -STEP_PX }[event.key];
    if (by_px === undefined) return;
    event.preventDefault();
    grow(by_px);
  });
  return grip;
}

// What the way is under the pointer.

import { make } from "../core/element";
import type { Units } from "../core/store";
import { feedText, timeText } from "../core/units";
import type { Robot } from "../run/run";
import { texts } from "../texts";

const words = texts.view;

export class Tooltip {
  readonly element = make("div", { class: "tip", role: "status", hidden: true });

  show(robot: Robot, segment: number, units: Units, x_px: number, y_px: number): void {
    const info = robot.segments.info(segment);
    const file = (robot.files[info.file] ?? "").replace(/^.*\//, "");
    const what: string[] = [words.classes[info.kind]];
    if (info.feed_per_min > 0) what.push(feedText(info.feed_per_min / 60, units));
    this.element.replaceChildren(
      make("b", {}, `${file}:${info.line}`),
      make("span", {}, what.join(", ")),
      make("span", {}, `${timeText(info.start_s)} + ${timeText(info.duration_s)}`),
    );
    this.element.hidden = false;
    this.element.style.transform = `translate(${x_px + 14}px, ${y_px + 14}px)`;
    const { offsetWidth, offsetHeight, parentElement } = this.element;
    const left = x_px + 14 + offsetWidth > (parentElement?.clientWidth ?? 0) ? x_px - 10 - offsetWidth : x_px + 14;
    const top = y_px + 14 + offsetHeight > (parentElement?.clientHeight ?? 0) ? y_px - 10 - offsetHeight : y_px + 14;
    this.element.style.transform = `translate(${left}px, ${top}px)`;
  }

  hide(): void {
    this.element.hidden = true;
  }
}

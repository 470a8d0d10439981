// Data of the path under the pointer.

import { element } from "../core/dom";
import { baseName } from "../core/file_kinds";
import type { Units } from "../core/store";
import { programmedFeedText, timeText } from "../core/units";
import type { Robot } from "../run/run";
import type { MoveKind } from "../run/kinds";
import { texts } from "../texts";

export class Tooltip {
  readonly element = element("div", { class: "tip", role: "status", hidden: true });

  /** `kind` is that of the move, which is known before all of it is loaded. */
  show(robot: Robot, segment: number, kind: MoveKind, units: Units, x_px: number, y_px: number): void {
    const { segments } = robot;
    const info = segments.info(segment);
    const { file, line } = segments.lineOf(segment);
    const start_s = segments.start_s(segment);
    const what: string[] = [texts.run.kinds[info?.kind ?? kind]];
    if (info && info.feed_per_min > 0) what.push(programmedFeedText(info.feed_per_min, info.length_mm, units));
    this.element.replaceChildren(
      element("b", {}, `${baseName(robot.files[file] ?? "")}:${line}`),
      element("span", {}, what.join(", ")),
      element("span", {}, info ? `${timeText(start_s)} + ${timeText(info.duration_s)}` : timeText(start_s, 1)),
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

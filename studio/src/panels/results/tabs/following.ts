// Actual positions of axes and TCP: the following error of each axis, and the largest distance of the TCP
// from its path.

import { element } from "../../../core/dom";
import { goTo } from "../../../core/navigation";
import type { Store } from "../../../core/store";
import { axisText, valueText, lengthText, timeText } from "../../../core/units";
import type { AxisFollowing, ContourError, Following } from "../../../run/report";
import { texts } from "../../../texts";
import { itemList, type Item } from "../mark_list";
import { axisTable, type AxisRow } from "./axis_rows";
import { metricItem } from "./metric_item";

const words = texts.panels.following;

const MS_PER_S = 1000;

export function createFollowingErrors(following: Following, store: Store): HTMLElement {
  const { contour, rapid_contour, program_contour, in_position_s } = following;
  const contours = [
    contourItem(words.contour, contour),
    contourItem(words.rapidContour, rapid_contour),
    ...(program_contour ? [contourItem(words.programContour, program_contour)] : []),
  ];
  const settlingTime = in_position_s === null ? words.notSettled : timeText(in_position_s);
  return element(
    "section",
    {},
    element("h3", { class: "heading", title: words.hint }, words.title),
    axisTable(words.heads, following.axes.map(createRow), store),
    element("h3", { class: "heading", title: words.contourHint }, words.contourTitle),
    itemList(words.contourTitle, contours, contours.length),
    element("dl", { class: "figures" }, metricItem(words.inPosition, settlingTime, words.inPositionHint)),
  );

  function createRow({ axis, unit, peak, rms, lag_s, file, line, t_s }: AxisFollowing): AxisRow {
    const amount = (value: number) => axisText(value, unit === "deg", store.get("units"));
    const cells = [amount(peak), amount(rms), valueText(MS_PER_S * lag_s)];
    return { axis, t_s, file, line, cells, title: words.rowHint(timeText(t_s, 2)), isOutOfRange: false };
  }

  function contourItem(text: (error: string) => string, at: ContourError): Item {
    const place = [timeText(at.t_s, 2), ...(at.line === null ? [] : [texts.run.line(at.line)])].join(" · ");
    const error = lengthText(at.error_mm, store.get("units"));
    return { kind: "", text: text(error), title: at.file ?? "", place, choose: () => goTo(store, at, at.t_s) };
  }
}

// Efforts of the motors by axis, and the energy of each program.

import { element } from "../../../core/dom";
import type { Store } from "../../../core/store";
import { energyText, valueText, percentText, timeText } from "../../../core/units";
import type { AxisEffort, Efforts } from "../../../run/report";
import { texts } from "../../../texts";
import { itemList } from "../mark_list";
import { axisTable, type AxisRow } from "./axis_rows";
import { metricItem } from "./metric_item";

const words = texts.panels.efforts;

export function createEfforts(efforts: Efforts, store: Store): HTMLElement {
  const { peak_power_w, peak_power_t_s, programs } = efforts;
  const power = {
    kind: "",
    text: words.peakPower(valueText(peak_power_w)),
    title: texts.panels.goThere,
    place: timeText(peak_power_t_s, 2),
    choose: () => store.set("time_s", peak_power_t_s),
  };
  const energies = element("dl", { class: "figures" });
  for (const key of ["in_j", "back_j", "friction_j"] as const) {
    energies.append(metricItem(words.energies[key], energyText(efforts[key]), words.energyHints[key]));
  }
  return element(
    "section",
    {},
    element("h3", { class: "heading" }, words.title),
    axisTable(words.heads, efforts.axes.map(createRow), store),
    itemList(words.power, [power], 1),
    energies,
    ...(programs.length > 1 ? [programTable(programs)] : []),
  );
}

function createRow(of: AxisEffort): AxisRow {
  const { axis, unit, peak, rms, motor_peak, motor_continuous, file, line, t_s } = of;
  const amount = (value: number | null) => (value === null ? words.notTold : `${valueText(value)} ${unit}`);
  const share = motor_peak ? Math.abs(peak) / motor_peak : null;
  const isOutOfRange = (share ?? 0) > 1 || (motor_continuous !== null && rms > motor_continuous);
  const cells = [amount(peak), amount(rms), share === null ? "–" : gauge(share)];
  const title = words.rowHint(timeText(t_s, 2), amount(motor_peak), amount(motor_continuous));
  return { axis, t_s, file, line, cells, title, isOutOfRange };
}

/** Shows the used share of the motor's capability. */
function gauge(share: number): HTMLElement {
  const text = `${percentText(share, 1)} %`;
  const bar = element("i", { style: `left:0;width:${Math.min(100 * share, 100)}%` });
  return element("div", { class: "of-motor" }, element("div", { class: "gauge", "aria-hidden": "true" }, bar), text);
}

function programTable(programs: Efforts["programs"]): HTMLElement {
  const head = element("tr", {}, ...words.programHeads.map((name) => element("th", { scope: "col" }, name)));
  const rows = programs.map(({ program, time_s, in_j, back_j }) =>
    element(
      "tr",
      {},
      element("th", { scope: "row" }, program ?? words.mainProgram),
      ...[timeText(time_s, 2), energyText(in_j), energyText(back_j)].map((text) => element("td", {}, text)),
    ),
  );
  return element("table", { class: "travel programs" }, element("thead", {}, head), element("tbody", {}, ...rows));
}

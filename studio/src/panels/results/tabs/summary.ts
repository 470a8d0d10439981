// Summary of the run: times, lengths, travel, and the points that need attention.

import { kindColours } from "../../../core/colours";
import { element } from "../../../core/dom";
import { goTo } from "../../../core/navigation";
import type { Store } from "../../../core/store";
import { axisText, countText, lengthShort, percentText, timeText } from "../../../core/units";
import { runMarks, type Mark, type MarkKind } from "../../../run/marks";
import type { Report, ReportDiagnostic } from "../../../run/report";
import { texts } from "../../../texts";
import type { Context, Tab } from "../context";
import { markItem, section, type Item } from "../mark_list";
import { createEfforts } from "./efforts";
import { createFollowingErrors } from "./following";
import { metricItem } from "./metric_item";
import { createTravel } from "./travel";

const words = texts.panels;

export function createSummary(store: Store): Tab {
  const host = element("div", { class: "summary" });
  return {
    element: host,
    draw(context) {
      const { report } = context;
      const diagnostics = diagnosticItems(context, store);
      host.replaceChildren();
      if (!report) return;
      host.append(...sections(context, severeKinds, store));
      if (report.cycle_time_s > 0) host.append(figures(report, store));
      host.append(...sections(context, minorKinds, store));
      if (diagnostics.length > 0) host.append(section(words.messages, "finding", diagnostics));
      if (report.efforts) host.append(createEfforts(report.efforts, store));
      if (report.following) host.append(createFollowingErrors(report.following, store));
      if (context.robot && report.bounds) host.append(createTravel(context.robot.scene.axes, report.bounds, axisWords));
    },
  };

  function axisWords(value: number, rotary: boolean): string {
    return axisText(value, rotary, store.get("units"));
  }
}

// Errors that make a run useless come before its values, warnings after them.
const severeKinds: readonly MarkKind[] = ["alarm", "collision", "violation", "zone"];
const minorKinds: readonly MarkKind[] = ["motor", "finding", "near"];

function sections({ run, index }: Context, kinds: readonly MarkKind[], store: Store): HTMLElement[] {
  const byKind = new Map<MarkKind, Mark[]>();
  for (const mark of runMarks(run, index)) {
    const known = byKind.get(mark.kind);
    if (known) known.push(mark);
    else byKind.set(mark.kind, [mark]);
  }
  return kinds
    .filter((kind) => byKind.has(kind))
    .map((kind) => section(words.sections[kind], kind, byKind.get(kind)!.map((mark) => markItem(mark, store))));
}

/** Returns diagnostics and warnings that are in no other list. */
function diagnosticItems({ run, report }: Context, store: Store): Item[] {
  if (!report || run.error) return [];
  const own = ["collision", "near-miss", "axis-limit", "zone", report.alarm?.code];
  for (const { code } of report.findings ?? []) own.push(code);
  // Motor diagnostics without a source location are in no list.
  const isListed = ({ code, line }: ReportDiagnostic) => own.includes(code) || (code === "motor-peak" && line !== null);
  const diagnostics = (report.diagnostics ?? []).filter((one) => !isListed(one));
  const known = new Set(diagnostics.map(({ text }) => text));
  const common = run.report !== report ? (run.report?.warnings ?? []) : [];
  const warnings = [...report.warnings, ...common].filter((text) => !known.has(text));
  return [
    ...diagnostics.map((one) => ({
      kind: one.severity,
      text: one.hint ? `${one.text}. ${one.hint}` : one.text,
      title: one.file ?? "",
      place: one.line === null ? words.severities[one.severity] : texts.run.line(one.line),
      choose: () => goTo(store, one, null),
    })),
    ...warnings.map((text) => {
      return { kind: "warning", text, title: "", place: words.severities.warning, choose: () => {} };
    }),
  ];
}

function figures(report: Report & { idle_s?: number }, store: Store): HTMLElement {
  const { time, length, lower_bound_s: bound_s, cycle_time_s: total_s } = report;
  const units = store.get("units");
  const list = element("dl", { class: "figures" }, metricItem(words.cycleTime, timeText(total_s)));
  list.firstElementChild!.classList.add("great");
  if (time) list.append(timeBar(time, total_s));
  if (bound_s != null && total_s > 0) {
    const beyond = words.boundShare(percentText(total_s - bound_s, total_s));
    list.append(metricItem(words.bound, timeText(bound_s), words.boundHint), element("p", { class: "note" }, beyond));
  }
  if (report.idle_s !== undefined) list.append(metricItem(words.idle, timeText(report.idle_s)));
  if (length) {
    list.append(metricItem(words.feedLength, lengthShort(length.feed_mm, units)));
    list.append(metricItem(words.rapidLength, lengthShort(length.rapid_mm, units)));
    if (length.process_on_mm > 0) list.append(metricItem(words.process, lengthShort(length.process_on_mm, units)));
  }
  if (report.blocks !== undefined) list.append(metricItem(words.blocks, countText(report.blocks)));
  if (report.moves !== undefined) list.append(metricItem(words.moves, countText(report.moves)));
  list.append(metricItem(words.machine, report.machine), metricItem(words.controller, report.controller ?? "–"));
  return list;
}

/** Shows time at feed, in rapids and in dwells as parts of one bar. */
function timeBar(time: NonNullable<Report["time"]>, total_s: number): HTMLElement {
  const parts = [
    { name: words.timeOf.feed, time_s: time.feed_s, kind: "feed" },
    { name: words.timeOf.rapid, time_s: time.rapid_s, kind: "rapid" },
    { name: words.timeOf.dwell, time_s: time.dwell_s, kind: "dwell" },
  ];
  const bar = element(
    "div",
    { class: "time-bar", "aria-hidden": "true" },
    ...parts.map(({ time_s, kind }) => element("i", { class: kind, style: `flex-grow:${time_s / total_s}` })),
  );
  const figures = parts.map(({ name, time_s, kind }) => {
    const row = metricItem(name, `${timeText(time_s)} · ${percentText(time_s, total_s)} %`);
    row.classList.add("of-time", kind);
    return row;
  });
  const colours = `--feed:${kindColours.linear};--rapid:${kindColours.rapid};--dwell:${kindColours.dwell}`;
  return element("div", { class: "time-parts", style: colours }, bar, ...figures);
}

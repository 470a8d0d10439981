// Marks of a run, in the order of time: events, alarms, exceeded limits, contacts, findings.

import type { LocatedEntry, Report } from "./report";
import type { Robot, Run } from "./run";

export const markKinds = ["alarm", "collision", "violation", "zone", "motor", "finding", "near", "event"] as const;
/** Kinds, the most severe first; "near" is a clearance below the requested one. */
export type MarkKind = (typeof markKinds)[number];

export interface Mark extends LocatedEntry {
  t_s: number;
  kind: MarkKind;
  /** Kind of an event, or the message of any other mark. */
  text: string;
  detail: string;
  /** Of contacts and clearances. */
  pair: [string, string] | null;
  clearance_mm: number;
}

const placed = (from: LocatedEntry): LocatedEntry => ({ file: from.file, line: from.line });
const plain = { detail: "", pair: null, clearance_mm: 0 };

/** Returns the first motion of a line, s. */
function lineStart_s(robot: Robot | undefined, { file, line }: LocatedEntry): number {
  if (!robot || file === null || line === null) return 0;
  const block = robot.blocks.firstOf(robot.files.indexOf(file), line);
  return block < 0 ? 0 : robot.blocks.start_s(block);
}

function* unordered(report: Report, robot: Robot | undefined): Generator<Mark> {
  for (const event of report.events ?? []) {
    yield { ...plain, ...placed(event), t_s: event.t_s, kind: "event", text: event.kind, detail: event.detail ?? "" };
  }
  for (const violation of report.violations ?? []) {
    const kind = violation.zone === null ? "violation" : "zone";
    yield { ...plain, ...placed(violation), t_s: violation.t_s, kind, text: violation.message };
  }
  for (const excess of report.efforts?.excesses ?? []) {
    if (excess.kind === "continuous") continue; // of the complete run
    yield { ...plain, ...placed(excess), t_s: excess.t_s, kind: "motor", text: excess.message };
  }
  for (const finding of report.findings ?? []) {
    yield { ...plain, ...placed(finding), t_s: finding.t_s, kind: "finding", text: finding.message };
  }
  for (const { t_s, kind, pair, ...place } of report.collisions ?? []) {
    yield { ...plain, ...placed(place), t_s, kind: "collision", text: kind, pair };
  }
  for (const { t_s, clearance_mm, pair, ...place } of report.clearances ?? []) {
    if (clearance_mm <= 0) continue; // a contact, which is there as such
    yield { ...plain, ...placed(place), t_s: t_s ?? lineStart_s(robot, place), kind: "near", text: "", pair, clearance_mm };
  }
  if (report.alarm) {
    yield { ...plain, ...placed(report.alarm), t_s: report.cycle_time_s, kind: "alarm", text: report.alarm.message };
  }
}

/**
 * Returns the marks of one robot; a clearance with unknown time is placed at the first motion of its line.
 */
export function runMarks(run: Run, index: number): Mark[] {
  const report = run.reportOf(index);
  if (!report) return [];
  const marks = [...unordered(report, run.robots[index])];
  const common = run.report?.robots && !report.alarm ? run.report.alarm : null;
  if (common) {
    marks.push({ ...plain, ...placed(common), t_s: run.report!.cycle_time_s, kind: "alarm", text: common.message });
  }
  return marks.sort((a, b) => a.t_s - b.t_s);
}

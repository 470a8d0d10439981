// Words about variants that several modules use.

import { shortName } from "../../core/file_kinds";
import { emptySetup, overrideKeys, type Setup } from "../../core/setup";
import { timeText } from "../../core/units";
import type { Run } from "../../run/run";
import { texts } from "../../texts";
import { blockOf } from "./data/differences";
import type { VariantStatus } from "./data/results";
import type { StartBlock, Variant } from "./data/variants_file";

const words = texts.variants;

/** "+1.250 s" */
export const signedTime = (difference_s: number): string => `${difference_s < 0 ? "−" : "+"}${timeText(Math.abs(difference_s))}`;

export const startText = ({ line, pass }: StartBlock): string => words.from(line, pass);

/**
 * Returns the differences of a setup from another one, in few words; for that one itself, its differences
 * from an empty one.
 */
function setupText(setup: Readonly<Setup>, first: Readonly<Setup>): string[] {
  const base = setup === first ? emptySetup() : first;
  const said: string[] = [];
  for (const key of ["program", "machine", "controller", "cell", "machine_data", "robots", "dialect"] as const) {
    if (setup[key] === base[key]) continue;
    const none = key === "machine" ? words.builtInMachine : `${words.of[key].toLowerCase()} ${words.none}`;
    said.push(setup[key] ? shortName(setup[key]) : none);
  }
  for (const key of overrideKeys) if (setup[key] !== base[key]) said.push(`${words.short[key]} ${setup[key]} %`);
  if (setup.collisions !== base.collisions) said.push(setup.collisions ? words.of.collisions.toLowerCase() : words.collisionsOff);
  return said;
}

/** Returns the differences of a variant from the first one. */
export function variantText({ setup, from }: Variant, first: Variant): string {
  const said = [...setupText(setup, first.setup), ...(from ? [startText(from)] : [])];
  return said.join(", ") || words.as;
}

/** Returns the status of a run and its severity. */
export function statusText(standing: VariantStatus): [text: string, severity: "" | "error" | "good"] {
  switch (standing.is) {
    case "none":
    case "dropped":
      return [words.standing[standing.is], ""];
    case "earlier":
      return [words.standing.earlier(standing.files.map(shortName)), ""];
    case "failed":
      return [words.standing.failed(standing.why), "error"];
    default:
      return errorText(standing.run, standing.is === "stopped");
  }
}

function errorText(run: Run, stopped: boolean): [string, "error" | "good"] {
  const said: string[] = [];
  const reports = run.robots.length > 0 ? run.robots.map((_, i) => run.reportOf(i)) : [run.report];
  const count = (of: (report: NonNullable<Run["report"]>) => number) => reports.reduce((sum, report) => sum + (report ? of(report) : 0), 0);
  const [contacts, violations] = [count(({ collisions }) => collisions?.length ?? 0), count((report) => report.violation_count ?? 0)];
  if (stopped) said.push(words.standing.stopped(run.report?.alarm?.message ?? run.report?.status ?? ""));
  if (contacts > 0) said.push(words.standing.collisions(contacts));
  if (violations > 0) said.push(words.standing.violations(violations));
  return said.length > 0 ? [said.join(", "), "error"] : [words.standing.good, "good"];
}

/** Returns the time from the start of the count to the end of the run, s; null: the run never reaches it. */
export function countedTime_s(run: Run, from: StartBlock | null, robot: number): number | null {
  const machine = run.robots[robot] ?? run.robots[0];
  if (!from) return run.end_s;
  const block = machine ? blockOf(machine, from) : -1;
  return block < 0 ? null : run.end_s - machine.blocks.start_s(block);
}

/** Returns the time of a run with results, and a note on it. */
export function runTime(run: Run, from: StartBlock | null, robot: number, stopped: boolean): [text: string, note: string] {
  if (stopped) return [words.stoppedAt(timeText(run.end_s)), ""];
  const counted_s = countedTime_s(run, from, robot);
  if (counted_s === null) return ["–", words.lineNotReached(from!.line)];
  return [timeText(counted_s), from ? words.fromLine(from.line, timeText(run.end_s)) : ""];
}

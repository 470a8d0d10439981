// Time of each tool in the machine.

import type { Report } from "../../../run/report";

export interface ToolTime {
  /** Tool name; empty: none yet. */
  name: string;
  time_s: number;
  /** When it first comes in. */
  start_s: number;
}

/** Returns times from tool changes; without changes, from tool selections. Empty: neither. */
export function timeByTool(report: Report): ToolTime[] {
  const events = report.events ?? [];
  const changes = events.filter(({ kind }) => kind === "tool_change" || kind === "tool_number");
  const from = changes.length > 0 ? changes : events.filter(({ kind }) => kind === "tool_select");
  if (from.length === 0) return [];
  const times = new Map<string, ToolTime>();
  const add = (name: string, start_s: number, end_s: number) => {
    const known = times.get(name) ?? { name, time_s: 0, start_s };
    known.time_s += end_s - start_s;
    times.set(name, known);
  };
  if (from[0].t_s > 0) add("", 0, from[0].t_s);
  from.forEach((event, i) => add(event.detail ?? event.kind, event.t_s, from[i + 1]?.t_s ?? report.cycle_time_s));
  return [...times.values()];
}

// Findings of the engine on a file, from checking its text or running it, as marks in the editor.

import type { Diagnostic } from "@codemirror/lint";
import type { Text } from "@codemirror/state";
import { element } from "../core/dom";
import type { LocatedEntry, Report, Severity } from "../run/report";
import type { Run } from "../run/run";

export interface Finding {
  severity: Severity;
  code: string;
  line: number;
  /** Counted from 1; 0: the complete line. */
  column: number;
  end_column: number;
  text: string;
  hint: string;
}

/** Max number of marks; a program with more findings has other problems. */
const MAX_FINDINGS = 1000;
const MAX_FINDINGS_PER_LINE = 5;

/**
 * Diagnostic with its words in `text`, as the engine sends it, or in `message`, as in other lists of a run's
 * report.
 */
type RawFinding = LocatedEntry & {
  severity?: Severity;
  code?: string;
  column?: number | null;
  end_column?: number | null;
  text?: string;
  message?: string;
  hint?: string | null;
};

function toFinding(rawFinding: RawFinding, severity: Severity): Finding {
  return {
    severity: rawFinding.severity ?? severity,
    code: rawFinding.code ?? "",
    line: rawFinding.line ?? 0,
    column: rawFinding.column ?? 0,
    end_column: rawFinding.end_column ?? 0,
    text: rawFinding.text ?? rawFinding.message ?? "",
    hint: rawFinding.hint ?? "",
  };
}

/** Returns the findings of a file, each once: a later one with the words of an earlier one is dropped. */
export function fileFindings(file: string, all: Iterable<[RawFinding, Severity]>): Finding[] {
  const found: Finding[] = [];
  const byLine = new Map<number, Finding[]>();
  for (const [rawFinding, severity] of all) {
    if (rawFinding.file !== file || !rawFinding.line) continue;
    const finding = toFinding(rawFinding, severity);
    const before = byLine.get(finding.line) ?? [];
    const isKnown = before.some(({ text }) => text.includes(finding.text) || finding.text.includes(text));
    if (isKnown || before.length >= MAX_FINDINGS_PER_LINE) continue;
    byLine.set(finding.line, [...before, finding]);
    found.push(finding);
    if (found.length >= MAX_FINDINGS) break;
  }
  return found;
}

/**
 * Returns the findings of a report. Its diagnostics are complete, including alarms, limits and collisions.
 */
function* reportFindings(report: Report): Generator<[RawFinding, Severity]> {
  for (const one of report.diagnostics ?? []) yield [one, one.severity];
  for (const robot of report.robots ?? []) yield* reportFindings(robot);
}

function* runDiagnostics(run: Run): Generator<[RawFinding, Severity]> {
  for (const one of run.diagnostics) yield [one, one.severity];
  if (run.report) yield* reportFindings(run.report);
}

export const runFindings = (run: Run, file: string): Finding[] => fileFindings(file, runDiagnostics(run));

const severities = { error: "error", warning: "warning", note: "info" } as const;

function createMessage({ text, hint }: Finding): Node {
  const message = element("div", { class: "code-message" }, text);
  if (hint) message.append(element("div", { class: "code-hint" }, hint));
  return message;
}

/** Converts a finding. `line`: the current position of the finding's line. */
export function toDiagnostic(doc: Text, finding: Finding, line: number): Diagnostic {
  const { from, to, length } = doc.line(line);
  const begin = Math.min(Math.max(finding.column - 1, 0), length);
  const end = finding.end_column > finding.column ? Math.min(finding.end_column - 1, length) : length;
  return {
    from: from + begin,
    to: finding.column > 0 ? Math.max(from + end, Math.min(from + begin + 1, to)) : to,
    severity: severities[finding.severity],
    message: finding.hint ? `${finding.text} (${finding.hint})` : finding.text,
    source: finding.code,
    renderMessage: () => createMessage(finding),
  };
}

// What the engine has to say of a file, by checking its text or by running it, as marks in the editor.

import type { Diagnostic } from "@codemirror/lint";
import type { Text } from "@codemirror/state";
import { element } from "../core/dom";
import type { Placed, Report, Severity } from "../run/report";
import type { Run } from "../run/run";

export interface Finding {
  severity: Severity;
  code: string;
  line: number;
  /** Counted from 1; 0: the whole line. */
  column: number;
  end_column: number;
  text: string;
  hint: string;
}

/** So many are marked; a program that has more has other troubles. */
const MOST = 1000;
const MOST_OF_LINE = 5;

/** What the engine tells has its words in `text`, where reports of a run have them in `message` in other lists. */
type Worded = Placed & {
  severity?: Severity;
  code?: string;
  column?: number | null;
  end_column?: number | null;
  text?: string;
  message?: string;
  hint?: string | null;
};

function findingOf(worded: Worded, severity: Severity): Finding {
  return {
    severity: worded.severity ?? severity,
    code: worded.code ?? "",
    line: worded.line ?? 0,
    column: worded.column ?? 0,
    end_column: worded.end_column ?? 0,
    text: worded.text ?? worded.message ?? "",
    hint: worded.hint ?? "",
  };
}

/** Those of a file, each once: what comes later and has the words of one before says nothing new. */
export function findingsOf(file: string, all: Iterable<[Worded, Severity]>): Finding[] {
  const found: Finding[] = [];
  const byLine = new Map<number, Finding[]>();
  for (const [worded, severity] of all) {
    if (worded.file !== file || !worded.line) continue;
    const finding = findingOf(worded, severity);
    const before = byLine.get(finding.line) ?? [];
    const isKnown = before.some(({ text }) => text.includes(finding.text) || finding.text.includes(text));
    if (isKnown || before.length >= MOST_OF_LINE) continue;
    byLine.set(finding.line, [...before, finding]);
    found.push(finding);
    if (found.length >= MOST) break;
  }
  return found;
}

/** Diagnostics of a report have all that there is to tell, alarms, limits and collisions among it. */
function* inReport(report: Report): Generator<[Worded, Severity]> {
  for (const one of report.diagnostics ?? []) yield [one, one.severity];
  for (const robot of report.robots ?? []) yield* inReport(robot);
}

function* inRun(run: Run): Generator<[Worded, Severity]> {
  for (const one of run.told) yield [one, one.severity];
  if (run.report) yield* inReport(run.report);
}

export const findingsOfRun = (run: Run, file: string): Finding[] => findingsOf(file, inRun(run));

const severities = { error: "error", warning: "warning", note: "info" } as const;

function messageOf({ text, hint }: Finding): Node {
  const message = element("div", { class: "code-message" }, text);
  if (hint) message.append(element("div", { class: "code-hint" }, hint));
  return message;
}

/** `line`: where the finding's line now is. */
export function diagnosticOf(doc: Text, finding: Finding, line: number): Diagnostic {
  const { from, to, length } = doc.line(line);
  const begin = Math.min(Math.max(finding.column - 1, 0), length);
  const end = finding.end_column > finding.column ? Math.min(finding.end_column - 1, length) : length;
  return {
    from: from + begin,
    to: finding.column > 0 ? Math.max(from + end, Math.min(from + begin + 1, to)) : to,
    severity: severities[finding.severity],
    message: finding.hint ? `${finding.text} (${finding.hint})` : finding.text,
    source: finding.code,
    renderMessage: () => messageOf(finding),
  };
}

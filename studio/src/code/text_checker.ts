// Checks the text during typing, and shows the findings of a run in it.

import { setDiagnostics, type Diagnostic } from "@codemirror/lint";
import { Debounced } from "../core/debounced";
import type { Session } from "../core/session";
import type { Store } from "../core/store";
import { programmaticEdit } from "./editor";
import { toDiagnostic, fileFindings, runFindings, type Finding } from "./findings";
import type { SourcePane } from "./source_pane";

const PAUSE_MS = 300;
/** Longer programs are checked after the user pauses for so long. */
const MAX_LIVE_CHECK_LINES = 200_000;
const LONG_PAUSE_MS = 3000;

export interface Problems {
  errors: number;
  warnings: number;
  /** True while a result is pending. */
  checking: boolean;
  /** The text is not in the page. */
  isNotLoaded: boolean;
}

export class TextChecker {
  private readonly debounced = new Debounced(() => void this.check());
  private findingsOfText: Finding[] = [];
  private findingsOfRun: Finding[] = [];
  /** Results for earlier versions are dropped. */
  private version = 0;
  private isRequestPending = false;

  /** `onChecked` is called after the present text has been checked. */
  constructor(
    private readonly store: Store,
    private readonly session: Session,
    private readonly source: SourcePane,
    private readonly onProblems: (problems: Problems) => void,
    private readonly onChecked: (hasErrors: boolean) => void,
  ) {}

  /** Another text is shown. */
  onDisplayed(): void {
    this.findingsOfText = [];
    this.onRunChanged();
    this.scheduleCheck();
  }

  onEdit(pause_ms = PAUSE_MS): void {
    this.scheduleCheck(pause_ms);
  }

  onRunChanged(): void {
    const run = this.store.get("run");
    this.findingsOfRun = run ? runFindings(run, this.source.name) : [];
    this.show();
  }

  private scheduleCheck(pause_ms = PAUSE_MS): void {
    ++this.version;
    if (!this.session.canRun) return;
    this.debounced.after(this.source.editorFile.doc.lines > MAX_LIVE_CHECK_LINES ? LONG_PAUSE_MS : pause_ms);
  }

  private async check(): Promise<void> {
    // Only one check at a time: the next begins after this one has ended, with the text at that time.
    if (this.isRequestPending) return this.debounced.after(PAUSE_MS / 3);
    const { version } = this;
    const { name } = this.source;
    if (this.source.editorFile.doc.length === 0) return this.setFindings([], version);
    this.isRequestPending = true;
    this.source.flush();
    this.tell();
    const diagnostics = await (this.source.isProgram ? this.session.check(name) : this.session.checkFile(name));
    this.isRequestPending = false;
    this.setFindings(
      fileFindings(
        name,
        diagnostics.map((one) => [one, one.severity]),
      ),
      version,
    );
  }

  private setFindings(findings: Finding[], version: number): void {
    if (version !== this.version) return this.tell();
    this.findingsOfText = findings;
    this.show();
    this.onChecked(findings.some(({ severity }) => severity === "error"));
  }

  /**
   * Adds findings of the run if the line has not been edited since, and the check has not reported them
   * already.
   */
  private currentFindings(): [Finding, number][] {
    const { editorFile } = this.source;
    const known = new Set(this.findingsOfText.map(({ line, text }) => `${line} ${text}`));
    const found = this.findingsOfText.map((finding): [Finding, number] => [finding, finding.line]);
    for (const finding of this.findingsOfRun) {
      const line = editorFile.isEditedSinceRun(finding.line) ? 0 : editorFile.fromRunLine(finding.line);
      if (line > 0 && !known.has(`${line} ${finding.text}`)) found.push([finding, line]);
    }
    return found;
  }

  private show(): void {
    const { view } = this.source.editor;
    const { doc } = view.state;
    const marks: Diagnostic[] = [];
    for (const [finding, line] of this.currentFindings()) {
      if (line <= doc.lines) marks.push(toDiagnostic(doc, finding, line));
    }
    view.dispatch({ ...setDiagnostics(view.state, marks), annotations: programmaticEdit.of(true) });
    this.tell();
  }

  private tell(): void {
    const severities = this.currentFindings().map(([{ severity }]) => severity);
    this.onProblems({
      errors: severities.filter((severity) => severity === "error").length,
      warnings: severities.filter((severity) => severity === "warning").length,
      checking: this.isRequestPending,
      isNotLoaded: this.source.isNotLoaded,
    });
  }
}

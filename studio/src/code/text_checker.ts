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
const LONG_LINES = 200_000;
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
  private ofText: Finding[] = [];
  private ofRun: Finding[] = [];
  /** Results for earlier versions are dropped. */
  private version = 0;
  private isAsking = false;

  /** `answered` is called after the present text has been checked. */
  constructor(
    private readonly store: Store,
    private readonly session: Session,
    private readonly source: SourcePane,
    private readonly told: (problems: Problems) => void,
    private readonly onChecked: (hasErrors: boolean) => void,
  ) {}

  /** Another text is shown. */
  displayed(): void {
    this.ofText = [];
    this.ranAnew();
    this.scheduleCheck();
  }

  onEdit(pause_ms = PAUSE_MS): void {
    this.scheduleCheck(pause_ms);
  }

  ranAnew(): void {
    const run = this.store.get("run");
    this.ofRun = run ? runFindings(run, this.source.name) : [];
    this.show();
  }

  private scheduleCheck(pause_ms = PAUSE_MS): void {
    ++this.version;
    if (!this.session.canRun) return;
    this.debounced.after(this.source.sheet.doc.lines > LONG_LINES ? LONG_PAUSE_MS : pause_ms);
  }

  private async check(): Promise<void> {
    // Only one check at a time: the next begins after this one has ended, with the text at that time.
    if (this.isAsking) return this.debounced.after(PAUSE_MS / 3);
    const { version } = this;
    const { name } = this.source;
    if (this.source.sheet.doc.length === 0) return this.setFindings([], version);
    this.isAsking = true;
    this.source.flush();
    this.tell();
    const told = await (this.source.isProgram ? this.session.check(name) : this.session.checkFile(name));
    this.isAsking = false;
    this.setFindings(
      fileFindings(
        name,
        told.map((one) => [one, one.severity]),
      ),
      version,
    );
  }

  private setFindings(findings: Finding[], version: number): void {
    if (version !== this.version) return this.tell();
    this.ofText = findings;
    this.show();
    this.onChecked(findings.some(({ severity }) => severity === "error"));
  }

  /**
   * Adds findings of the run if the line has not been edited since, and the check has not reported them
   * already.
   */
  private present(): [Finding, number][] {
    const { sheet } = this.source;
    const known = new Set(this.ofText.map(({ line, text }) => `${line} ${text}`));
    const found = this.ofText.map((finding): [Finding, number] => [finding, finding.line]);
    for (const finding of this.ofRun) {
      const line = sheet.touched(finding.line) ? 0 : sheet.fromRunLine(finding.line);
      if (line > 0 && !known.has(`${line} ${finding.text}`)) found.push([finding, line]);
    }
    return found;
  }

  private show(): void {
    const { view } = this.source.editor;
    const { doc } = view.state;
    const marks: Diagnostic[] = [];
    for (const [finding, line] of this.present()) {
      if (line <= doc.lines) marks.push(toDiagnostic(doc, finding, line));
    }
    view.dispatch({ ...setDiagnostics(view.state, marks), annotations: programmaticEdit.of(true) });
    this.tell();
  }

  private tell(): void {
    const severities = this.present().map(([{ severity }]) => severity);
    this.told({
      errors: severities.filter((severity) => severity === "error").length,
      warnings: severities.filter((severity) => severity === "warning").length,
      checking: this.isAsking,
      isNotLoaded: this.source.isNotLoaded,
    });
  }
}

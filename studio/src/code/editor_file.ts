// File in the editor: its text, its history, and the relation of its lines to those of the run.

import { ChangeSet, type ChangeDesc, type EditorState, type Text } from "@codemirror/state";

/** Text at an instant, with the changes since then. */
interface Mark {
  text: Text;
  changes: ChangeDesc;
}

const createMark = (text: Text): Mark => ({ text, changes: ChangeSet.empty(text.length).desc });

/** Maps a line's start through a change of the text; 0: the line no longer exists. */
function mapLine(line: number, from: Text, changes: ChangeDesc, to: Text): number {
  if (line < 1 || line > from.lines) return 0;
  if (changes.empty) return line;
  return to.lineAt(changes.mapPos(from.line(line).from, 1)).number;
}

export class EditorFile {
  /** Text as it was opened, or saved last. */
  private kept: Text;
  private ran: Mark;
  private running: Mark | null = null;

  constructor(
    readonly name: string,
    public state: EditorState,
  ) {
    this.kept = state.doc;
    this.ran = createMark(state.doc);
  }

  get doc(): Text {
    return this.state.doc;
  }

  get isModified(): boolean {
    return !this.doc.eq(this.kept);
  }

  get isChangedSinceRun(): boolean {
    return !this.ran.changes.empty && !this.doc.eq(this.ran.text);
  }

  /** Marks the text as saved on a disk, or as a sample. */
  saved(): void {
    this.kept = this.doc;
  }

  changed(changes: ChangeDesc): void {
    for (const mark of [this.ran, this.running]) if (mark) mark.changes = mark.changes.composeDesc(changes);
  }

  /** Records that a run of the present text has begun. */
  beginRun(): void {
    this.running = createMark(this.doc);
  }

  /**
   * Records that the run begun last is now shown; for a run that existed before, the present text is used.
   */
  endRun(wasBegun: boolean): void {
    this.ran = wasBegun && this.running ? this.running : createMark(this.doc);
    this.running = null;
  }

  /** Returns a line of the run in the present text; 0: none. */
  fromRunLine(line: number): number {
    return mapLine(line, this.ran.text, this.ran.changes, this.doc);
  }

  /** Returns a line of the text as in the run; 0: it is new. */
  toRunLine(line: number): number {
    if (this.ran.changes.empty) return line <= this.doc.lines ? line : 0;
    const back = this.ran.changes.invertedDesc;
    const old = mapLine(line, this.doc, back, this.ran.text);
    return this.fromRunLine(old) === line ? old : 0;
  }

  /** Returns true if a line of the run has been edited since. */
  isEditedSinceRun(runLine: number): boolean {
    if (this.ran.changes.empty || runLine < 1 || runLine > this.ran.text.lines) return false;
    const { from, to } = this.ran.text.line(runLine);
    return this.ran.changes.touchesRange(from, to) !== false;
  }
}

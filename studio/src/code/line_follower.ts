// Synchronisation of code, time and selection. The line that the machine is executing is marked and kept in
// sight. A line that the user chooses is shown in the other parts of the page, and one chosen elsewhere gets
// the cursor.

import { showBlockStart } from "../core/navigation";
import { activeLine, shownRobot } from "../core/display_state";
import type { Store } from "../core/store";
import type { SourceLocation } from "../run/report";
import type { Editor } from "./editor";
import type { SourcePane } from "./source_pane";
import { OFFSET_LINES, type TranslationPane } from "./translation_pane";

/** After the user scrolls or types, the code does not move for so long. */
const IDLE_S = 2;

/** G-code and Lua side by side: they scroll together. */
export interface SplitView {
  isEnabled(): boolean;
  /** Scrolls the Lua to the position of the G-code. */
  align(): void;
}

export class LineFollower {
  private isUpdatingSelection = false;
  private isPending = false;
  private mayScroll = false;

  constructor(
    private readonly store: Store,
    private readonly source: SourcePane,
    private readonly translation: TranslationPane,
    private readonly split: SplitView,
  ) {
    store.on("time_s", () => this.later(!this.isUpdatingSelection));
    store.on("robot", () => this.later(false));
    store.on("loadCount", () => this.later(!this.isUpdatingSelection));
    store.on("selection", (place) => {
      if (place && !this.isUpdatingSelection) this.go(place);
      this.later(false);
    });
  }

  /** Handles the user's cursor on a line of the program. */
  choose(line: number): void {
    const { store, source } = this;
    const place = source.runLocation(line);
    const isNew = source.editorFile.toRunLine(line) === 0;
    this.isUpdatingSelection = true;
    store.set("selection", isNew ? null : { file: source.name, line: place?.line ?? line, block: -1 });
    const block = place ? (shownRobot(store)?.blocks.nearest(place.file, place.line, store.get("time_s")) ?? -1) : -1;
    if (block >= 0) showBlockStart(store, block);
    this.isUpdatingSelection = false;
  }

  /** Renews the mark without scrolling: another text or another run is shown. */
  refresh(): void {
    this.later(false);
  }

  /** Scrolls to the marked line after the user has opened the other pane. */
  reveal(): void {
    const place = activeLine(this.store);
    if (place?.file === this.source.name) this.revealLine(this.source.editorFile.fromRunLine(place.line));
  }

  private go({ file, line }: SourceLocation): void {
    if (file !== this.source.name) {
      if (!this.source.has(file)) return;
      this.source.show(file);
    }
    const here = this.source.editorFile.fromRunLine(line);
    this.source.editor.select(here);
    this.translation.editor.select(here + OFFSET_LINES);
    this.revealLine(here);
  }

  // Changes of the time within one frame are combined into one change of the mark.
  private later(mayScroll: boolean): void {
    this.mayScroll ||= mayScroll;
    if (this.isPending) return;
    this.isPending = true;
    requestAnimationFrame(() => {
      this.isPending = false;
      this.follow(this.mayScroll);
      this.mayScroll = false;
    });
  }

  private get isUserIdle(): boolean {
    return Math.min(this.source.editor.untouched_s, this.translation.editor.untouched_s) > IDLE_S;
  }

  private follow(mayScroll: boolean): void {
    const { source, translation } = this;
    const place = activeLine(this.store);
    const maySwitchFile = mayScroll && this.isUserIdle && source.isProgram;
    if (place && place.file !== source.name && maySwitchFile && source.has(place.file)) {
      source.show(place.file);
    }
    const line = place?.file === source.name ? source.editorFile.fromRunLine(place.line) : 0;
    mark(source.editor, line);
    mark(translation.editor, line > 0 ? line + OFFSET_LINES : 0);
    if (mayScroll && this.isUserIdle) this.revealLine(line);
  }

  private revealLine(line: number): void {
    const { source, translation, split } = this;
    if (!split.isEnabled()) {
      source.editor.reveal(line);
      translation.editor.reveal(line + OFFSET_LINES);
      return;
    }
    source.editor.reveal(line, translation.editor.view.scrollDOM.clientHeight - translation.editor.view.defaultLineHeight);
    split.align();
  }
}

const lastMarks = new WeakMap<Editor, [unknown, number]>();

/** Marks a line only if the editor does not show the mark already. */
function mark(editor: Editor, line: number): void {
  const { doc } = editor.view.state;
  const [before, beforeLine] = lastMarks.get(editor) ?? [null, 0];
  if (before === doc && beforeLine === line) return;
  editor.mark(line);
  lastMarks.set(editor, [doc, line]);
}

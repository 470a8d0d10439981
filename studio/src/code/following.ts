// Code, time and what is chosen go together: the line that the machine is at is marked and kept in sight, a line that
// a person chooses is shown to the rest of the page, and one that is chosen elsewhere gets the cursor.

import type { Place, Store } from "../core/store";
import { startNearest_s } from "./block_facts";
import type { Editor } from "./editor";
import type { SourcePane } from "./source_pane";
import { OFFSET_LINES, type TranslationPane } from "./translation_pane";

/** After a person's own scrolling or typing the code stays where it is for so long. */
const REST_S = 2;
/** The end of a run may be later than its last motion by rounding. */
const AT_END_S = 1e-6;

/** G-code and Lua beside each other: they scroll as one. */
export interface Split {
  isOn(): boolean;
  /** Brings the Lua to where the G-code is. */
  align(): void;
}

export class Following {
  private isOwn = false;
  private isDue = false;
  private mayScroll = false;

  constructor(
    private readonly store: Store,
    private readonly source: SourcePane,
    private readonly translation: TranslationPane,
    private readonly split: Split,
  ) {
    store.on("time_s", () => this.later(!this.isOwn));
    store.on("robot", () => this.later(false));
    store.on("selection", (place) => {
      if (place && !this.isOwn) this.go(place);
    });
  }

  /** A person has put the cursor on a line of the program. */
  choose(line: number): void {
    const { store, source } = this;
    const place = source.runPlace(line);
    const run = store.get("run");
    const isNew = source.sheet.runLineOf(line) === 0;
    this.isOwn = true;
    store.set("selection", isNew ? null : { file: source.name, line: place?.line ?? line, block: -1 });
    const robot = run?.robots[store.get("robot")];
    if (place && robot) {
      const start_s = startNearest_s(robot, place.file, place.line, store.get("time_s"));
      if (start_s >= 0) store.set("time_s", start_s);
    }
    this.isOwn = false;
  }

  /** Marks anew, without scrolling: another text or another run is shown. */
  renew(): void {
    this.later(false);
  }

  /** Scrolls to the marked line, where a person has asked to see the other pane. */
  reveal(): void {
    const place = this.present();
    if (place?.file === this.source.name) this.revealLine(this.source.sheet.lineOfRun(place.line));
  }

  private go({ file, line }: Place): void {
    if (file !== this.source.name) {
      if (!this.source.has(file)) return;
      this.source.show(file);
    }
    const here = this.source.sheet.lineOfRun(line);
    this.source.editor.select(here);
    this.translation.editor.select(here + OFFSET_LINES);
    this.revealLine(here);
  }

  // A frame's worth of changes of the time is one change of the mark.
  private later(mayScroll: boolean): void {
    this.mayScroll ||= mayScroll;
    if (this.isDue) return;
    this.isDue = true;
    requestAnimationFrame(() => {
      this.isDue = false;
      this.follow(this.mayScroll);
      this.mayScroll = false;
    });
  }

  private present(): Place | null {
    const robot = this.store.get("run")?.robots[this.store.get("robot")];
    const time_s = this.store.get("time_s");
    const segment = robot?.segments.at(time_s) ?? -1;
    // Of several robots one may be done before the others.
    if (!robot || segment < 0 || time_s > robot.segments.end_s + AT_END_S) return null;
    const [chunk, i] = robot.segments.locate(segment);
    return { file: robot.files[chunk.file[i]], line: chunk.line[i] };
  }

  private get isLeft(): boolean {
    return Math.min(this.source.editor.untouched_s, this.translation.editor.untouched_s) > REST_S;
  }

  private follow(mayScroll: boolean): void {
    const { source, translation } = this;
    const place = this.present();
    if (place && place.file !== source.name && mayScroll && this.isLeft && source.has(place.file)) {
      source.show(place.file);
    }
    const line = place?.file === source.name ? source.sheet.lineOfRun(place.line) : 0;
    mark(source.editor, line);
    mark(translation.editor, line > 0 ? line + OFFSET_LINES : 0);
    if (mayScroll && this.isLeft) this.revealLine(line);
  }

  private revealLine(line: number): void {
    const { source, translation, split } = this;
    if (!split.isOn()) {
      source.editor.reveal(line);
      translation.editor.reveal(line + OFFSET_LINES);
      return;
    }
    source.editor.reveal(line, translation.editor.view.scrollDOM.clientHeight - translation.editor.view.defaultLineHeight);
    split.align();
  }
}

const marked = new WeakMap<Editor, [unknown, number]>();

/** Spares the editor what it shows already. */
function mark(editor: Editor, line: number): void {
  const { doc } = editor.view.state;
  const [before, beforeLine] = marked.get(editor) ?? [null, 0];
  if (before === doc && beforeLine === line) return;
  editor.mark(line);
  marked.set(editor, [doc, line]);
}

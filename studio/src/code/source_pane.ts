// The program that is shown and edited: G-code, or a script in Lua.

import { toggleComment } from "@codemirror/commands";
import type { ChangeDesc, Extension } from "@codemirror/state";
import { keymap, type ViewUpdate } from "@codemirror/view";
import { Debounced } from "../core/debounced";
import { isScript } from "../core/kinds";
import type { Language } from "../core/languages";
import type { Session } from "../core/session";
import type { Store } from "../core/store";
import { texts } from "../texts";
import { toggleRemark } from "./comments";
import { completion } from "./completion";
import { Dialect, dialectName } from "./dialect";
import { Editor, byPage, type EditorEvents } from "./editor";
import { gcodeLanguage } from "./gcode_language";
import { hover } from "./hover";
import { luaLanguage } from "./lua_language";
import { ModalIndex, type ModalState } from "./modal";
import { Sheet } from "./sheet";

/** What a new program is called. */
const UNTITLED = "untitled.nc";

/** Longer texts are handed on when a person pauses. */
const AT_ONCE_UP_TO = 200_000;
const PAUSE_MS = 600;

export interface SourceEvents {
  /** Another file, or another text of it, is shown. */
  shown(): void;
  edited(): void;
  /** A person has put the cursor on a line. */
  chosen(line: number): void;
  /** The dialect is another one, or its tables have come. */
  renewed(): void;
  /** The cursor is elsewhere. */
  moved(): void;
  run(): void;
  leave(): void;
}

export class SourcePane {
  readonly editor: Editor;
  dialect: Dialect;
  sheet: Sheet;
  private languages: Language[] = [];
  private modal: ModalIndex;
  private readonly sheets = new Map<string, Sheet>();
  private readonly putting = new Debounced(() => this.put());
  private isPutting = false;

  constructor(
    host: HTMLElement,
    private readonly store: Store,
    private readonly session: Session,
    private readonly events: SourceEvents,
  ) {
    this.editor = new Editor(host, this.editorEvents(), texts.code.placeholder);
    this.dialect = new Dialect("ab9", null);
    this.modal = new ModalIndex(this.dialect);
    this.sheet = this.sheetOf(UNTITLED);
    session.documents.on((name) => this.replaced(name));
    void session.languages().then((languages) => {
      this.languages = languages;
      this.renew();
    });
    this.editor.view.contentDOM.addEventListener("blur", () => this.flush());
  }

  get name(): string {
    return this.sheet.name;
  }

  get isScript(): boolean {
    return isScript(this.name);
  }

  get readOnly(): boolean {
    const isKnown = this.name === UNTITLED || this.session.documents.get(this.name) !== undefined;
    return !this.session.canRun || !isKnown;
  }

  /** Whether there is a text of that name. */
  has(name: string): boolean {
    return this.session.documents.get(name) !== undefined || (this.store.get("run")?.sources.has(name) ?? false);
  }

  /** Empty: a new program. */
  show(name: string): void {
    this.flush();
    this.sheet = this.sheetOf(name || UNTITLED);
    this.editor.show(this.sheet.state);
    this.renew();
    this.events.shown();
  }

  /** After a change of the dialect, or of what is known of it. */
  renew(): void {
    const name = dialectName(this.session, this.name);
    this.dialect = new Dialect(name, this.languages.find((language) => language.name === name) ?? null);
    this.modal = new ModalIndex(this.dialect);
    this.editor.configure(this.configuration(this.name));
    this.events.renewed();
  }

  /** Hands on what has been typed. */
  flush(): void {
    this.putting.flush();
  }

  /** All files' texts are those of a run that begins, or of the one that has ended. */
  runBegins(): void {
    for (const sheet of this.sheets.values()) sheet.runBegins();
  }

  runEnds(): void {
    for (const sheet of this.sheets.values()) sheet.runEnds();
  }

  /** File and line of the shown run for a line of the text; null: it has not run. */
  runPlace(line: number): { file: number; line: number } | null {
    const file = this.store.get("run")?.fileOf(this.store.get("robot"), this.name) ?? -1;
    const ran = this.sheet.runLineOf(line);
    return file >= 0 && ran > 0 ? { file, line: ran } : null;
  }

  /** In force behind a line of the G-code. */
  modalAt(line: number): Promise<ModalState | null> {
    if (this.isScript) return Promise.resolve(null);
    const { doc } = this.editor.view.state;
    return this.modal.at(doc, line, () => this.editor.view.state.doc !== doc);
  }

  private sheetOf(name: string): Sheet {
    const known = this.sheets.get(name);
    if (known) return known;
    const { documents } = this.session;
    const isDocument = documents.get(name) !== undefined;
    const text = isDocument ? documents.text(name) : (this.store.get("run")?.sources.get(name) ?? "");
    const sheet = new Sheet(name, this.editor.stateOf(text, this.configuration(name)));
    this.sheets.set(name, sheet);
    return sheet;
  }

  private configuration(name: string) {
    const isLua = isScript(name);
    const language = isLua ? luaLanguage(this.dialect) : gcodeLanguage(this.dialect);
    const toggle = isLua ? toggleComment : toggleRemark(this.dialect.isNgc);
    const extensions: Extension = [
      language,
      completion(this.dialect, isLua),
      hover({
        store: this.store,
        dialect: () => this.dialect,
        runPlace: (line) => this.runPlace(line),
        modal: (line) => this.modalAt(line),
        isLua,
      }),
      keymap.of([{ key: "Mod-/", run: toggle, preventDefault: true }]),
    ];
    const readOnly = this.sheet !== undefined && this.readOnly;
    return { language: extensions, readOnly, label: texts.code.editorLabel(name) };
  }

  private editorEvents(): EditorEvents {
    return {
      updated: (update) => this.updated(update),
      gutterClicked: (line) => {
        this.editor.select(line);
        this.editor.view.focus();
        this.events.chosen(line);
      },
      run: () => this.events.run(),
      leave: () => this.events.leave(),
    };
  }

  private updated(update: ViewUpdate): void {
    this.sheet.state = update.state;
    if (update.selectionSet || update.docChanged) this.events.moved();
    if (update.transactions.some((transaction) => transaction.annotation(byPage))) return;
    if (update.docChanged) return this.changed(update.changes.desc);
    const { main } = update.state.selection;
    if (update.selectionSet && main.empty) this.events.chosen(update.state.doc.lineAt(main.head).number);
  }

  private changed(changes: ChangeDesc): void {
    this.sheet.changed(changes);
    let first = this.sheet.doc.length;
    changes.iterChangedRanges((_fromA, _toA, from) => (first = Math.min(first, from)));
    this.modal.changed(this.sheet.doc.lineAt(first).number);
    this.putting.after(PAUSE_MS);
    if (this.sheet.doc.length <= AT_ONCE_UP_TO) this.putting.flush();
    this.events.edited();
  }

  private put(): void {
    this.isPutting = true;
    this.session.documents.put(this.name, this.sheet.doc.toString());
    this.isPutting = false;
    if (this.session.setup.program === "") this.session.change({ program: this.name });
  }

  // By another part of the page, as when a file is dropped on it.
  private replaced(name: string): void {
    if (this.isPutting) return;
    if (name === this.session.setup.machine) this.renew();
    this.sheets.delete(name);
    if (name !== this.name) return;
    this.putting.cancel();
    this.show(name);
  }
}

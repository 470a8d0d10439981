// Pane that shows and edits the program: G-code, or a script in Lua.

import { isolateHistory, toggleComment } from "@codemirror/commands";
import { Transaction, type ChangeDesc, type Extension, type Text } from "@codemirror/state";
import { keymap, type ViewUpdate } from "@codemirror/view";
import { Debounced } from "../core/debounced";
import { defaultDialect } from "../core/dialects";
import { MAX_DOCUMENT_BYTES, UNTITLED } from "../core/documents";
import type { Change } from "../core/history";
import type { ActiveSettings } from "../core/active_modals";
import { baseName, isProgram, isScript } from "../core/file_kinds";
import type { Language } from "../core/languages";
import type { Session } from "../core/session";
import type { Store } from "../core/store";
import { texts } from "../texts";
import { toggleLineComment } from "./comments";
import { completion } from "./completion";
import { Dialect, dialectName } from "./dialect";
import { Editor, programmaticEdit, type EditorEvents } from "./editor";
import { gcodeLanguage } from "./gcode_language";
import { hover } from "./hover";
import { luaLanguage } from "./lua_language";
import { ModalIndex, type ModalState } from "./modal";
import { EditorFile } from "./editor_file";
import { textChange } from "./text_change";
import { tomlLanguage } from "./toml_language";

/** Longer texts are passed on after the user pauses. */
const MAX_IMMEDIATE_LENGTH = 200_000;
const PAUSE_MS = 600;

/** Returns the kind of edit, if consecutive edits of this kind are one undo step; empty: each is one. */
function editKind(update: ViewUpdate): string {
  const events = update.transactions.map((transaction) => transaction.annotation(Transaction.userEvent) ?? "");
  return /^(?:input\.type|delete\.(?:back|for)ward|undo|redo)/.exec(events.find((event) => event !== "") ?? "")?.[0] ?? "";
}

export interface SourceEvents {
  /** Another file is shown. */
  onDisplayed(): void;
  /** Handles another text, by the user or by another part of the page. */
  onEdit(): void;
  /** Handles the user's cursor on a line. */
  onLineSelected(line: number): void;
  /** Handles another dialect, or its loaded tables. */
  onDialectChange(): void;
  /** The cursor is elsewhere. */
  moved(): void;
  run(): void;
  /** Requests a run that continues from a line. */
  onRunFrom(line: number): void;
  leave(): void;
}

export class SourcePane {
  readonly editor: Editor;
  dialect: Dialect;
  editorFile: EditorFile;
  private languages: Language[] = [];
  private modal: ModalIndex;
  private readonly editorFiles = new Map<string, EditorFile>();
  private readonly storeTimer = new Debounced(() => this.put());
  private isStoring = false;
  /** What no document has yet. */
  private pendingEdit: { text: Text; kind: string } | null = null;

  constructor(
    host: HTMLElement,
    private readonly store: Store,
    private readonly session: Session,
    private readonly events: SourceEvents,
  ) {
    this.editor = new Editor(host, this.editorEvents());
    this.dialect = new Dialect(defaultDialect, null);
    this.modal = new ModalIndex(this.dialect);
    this.editorFile = this.editorFileFor(UNTITLED);
    session.documents.on((name) => this.replaced(name));
    session.history.onStep(() => this.flush());
    void session.languages().then((languages) => {
      this.languages = languages;
      this.refresh();
    });
    this.editor.view.contentDOM.addEventListener("blur", () => this.flush());
  }

  get name(): string {
    return this.editorFile.name;
  }

  get isScript(): boolean {
    return isScript(this.name);
  }

  /** Returns false for machines, cells and data, which are shown as text alone. */
  get isProgram(): boolean {
    return this.isProgramNamed(this.name);
  }

  get readOnly(): boolean {
    const isKnown = this.name === UNTITLED || this.session.documents.get(this.name) !== undefined;
    return !this.session.canRun || !isKnown;
  }

  /** Returns true if it runs, but its text is not in the page. */
  get isNotLoaded(): boolean {
    return this.session.documents.folderFileSize(this.name) !== undefined;
  }

  /** Returns true if a text of that name exists. */
  has(name: string): boolean {
    return this.session.documents.get(name) !== undefined || (this.store.get("run")?.sources.has(name) ?? false);
  }

  /** Empty: a new program. */
  show(name: string): void {
    this.flush();
    this.editorFile = this.editorFileFor(name || UNTITLED);
    this.editor.show(this.editorFile.state);
    this.store.set("document", this.name);
    this.refresh();
    this.events.onDisplayed();
  }

  /** Updates the pane after a change of the dialect, or of its tables. */
  refresh(): void {
    const name = dialectName(this.session, this.name);
    this.dialect = new Dialect(name, this.languages.find((language) => language.name === name) ?? null);
    this.modal = new ModalIndex(this.dialect);
    this.editor.configure(this.configuration(this.name));
    this.events.onDialectChange();
  }

  /** Passes on the typed text. */
  flush(): void {
    this.storeTimer.flush();
  }

  /** Marks the present texts of all files as those of the run that begins, or of the one that has ended. */
  beginRun(): void {
    for (const editorFile of this.editorFiles.values()) editorFile.beginRun();
  }

  endRun(wasBegun: boolean): void {
    for (const editorFile of this.editorFiles.values()) editorFile.endRun(wasBegun);
  }

  /** Returns file and line of the shown run for a line of the text; null: it has not run. */
  runLocation(line: number): { file: number; line: number } | null {
    const file = this.store.get("run")?.fileOf(this.store.get("robot"), this.name) ?? -1;
    const ran = this.editorFile.toRunLine(line);
    return file >= 0 && ran > 0 ? { file, line: ran } : null;
  }

  /** Returns the active codes after a line of the G-code; line 0: at the start. */
  modalAt(line: number): Promise<ModalState | null> {
    if (this.isScript || !this.isProgram) return Promise.resolve(null);
    const { doc } = this.editor.view.state;
    return this.modal.at(doc, line, () => this.editor.view.state.doc !== doc);
  }

  /**
   * Returns the active codes at the start of a line of the shown run; null: its text is not the one shown, or
   * no G-code.
   */
  async activeSettingsAt(file: string, runLine: number): Promise<ActiveSettings | null> {
    const line = file === this.name ? this.editorFile.fromRunLine(runLine) : 0;
    const state = line > 0 ? await this.modalAt(line - 1) : null;
    if (!state) return null;
    const codes = [...state.codes].map(([group, name]) => ({ name, group, meaning: this.dialect.codes.get(name)?.meaning ?? "" }));
    return { codes, words: [...state.words].map(([letter, value]) => letter + value), jumps: state.jumps };
  }

  private editorFileFor(name: string): EditorFile {
    const known = this.editorFiles.get(name);
    if (known) return known;
    const { documents } = this.session;
    const isDocument = documents.get(name) !== undefined;
    const text = isDocument ? documents.text(name) : (this.store.get("run")?.sources.get(name) ?? "");
    const editorFile = new EditorFile(name, this.editor.stateOf(text, this.configuration(name)));
    this.editorFiles.set(name, editorFile);
    return editorFile;
  }

  private isProgramNamed(name: string): boolean {
    return isProgram(name, this.session.documents.get(name) ?? "");
  }

  private configuration(name: string) {
    const readOnly = this.editorFile !== undefined && this.readOnly;
    if (this.isProgramNamed(name))
      return { language: this.programLanguage(name), readOnly, label: texts.code.editorLabel(name), hint: this.hintOf(name) };
    const language = [
      name.toLowerCase().endsWith(".toml") ? tomlLanguage : [],
      keymap.of([{ key: "Mod-/", run: toggleComment, preventDefault: true }]),
    ];
    return { language, readOnly, label: texts.code.textLabel(name), hint: this.hintOf(name) };
  }

  private programLanguage(name: string): Extension {
    const isLua = isScript(name);
    const language = isLua ? luaLanguage(this.dialect) : gcodeLanguage(this.dialect);
    const toggle = isLua ? toggleComment : toggleLineComment(this.dialect.properties.semicolonComments);
    return [
      language,
      completion(this.dialect, isLua),
      hover({
        store: this.store,
        dialect: () => this.dialect,
        runLocation: (line) => this.runLocation(line),
        modal: (line) => this.modalAt(line),
        isLua,
      }),
      keymap.of([
        { key: "Mod-/", run: toggle, preventDefault: true },
        { key: "Mod-Shift-Enter", run: () => this.onRunFrom(), preventDefault: true },
      ]),
    ];
  }

  private hintOf(name: string): string {
    const bytes = this.session.documents.folderFileSize(name);
    if (bytes === undefined) return texts.code.placeholder;
    return bytes > MAX_DOCUMENT_BYTES ? texts.folder.tooLarge(bytes) : texts.folder.loading;
  }

  private editorEvents(): EditorEvents {
    return {
      onUpdate: (update) => this.onUpdate(update),
      onGutterClick: (line) => {
        this.editor.select(line);
        this.editor.view.focus();
        if (this.isProgram) this.events.onLineSelected(line);
      },
      run: () => this.events.run(),
      leave: () => this.events.leave(),
    };
  }

  private onRunFrom(): boolean {
    const { state } = this.editor.view;
    this.events.onRunFrom(state.doc.lineAt(state.selection.main.head).number);
    return true;
  }

  private onUpdate(update: ViewUpdate): void {
    this.editorFile.state = update.state;
    if (update.selectionSet || update.docChanged) this.events.moved();
    if (update.transactions.some((transaction) => transaction.annotation(programmaticEdit))) return;
    if (update.docChanged) return this.onEdit(update);
    const { main } = update.state.selection;
    if (!this.isProgram) return;
    if (update.selectionSet && main.empty) this.events.onLineSelected(update.state.doc.lineAt(main.head).number);
  }

  private onEdit(update: ViewUpdate): void {
    const kind = editKind(update);
    if (this.pendingEdit && this.pendingEdit.kind !== kind) this.flush();
    this.pendingEdit = { text: update.state.doc, kind };
    this.storeTimer.after(PAUSE_MS);
    if (update.state.doc.length <= MAX_IMMEDIATE_LENGTH) this.flush();
    this.changed(update.changes.desc);
  }

  private changed(changes: ChangeDesc): void {
    this.editorFile.changed(changes);
    let first = this.editorFile.doc.length;
    changes.iterChangedRanges((_fromA, _toA, from) => (first = Math.min(first, from)));
    this.modal.changed(this.editorFile.doc.lineAt(first).number);
    this.events.onEdit();
  }

  private put(): void {
    if (!this.pendingEdit) return;
    const { name, session } = this;
    const { text, kind } = this.pendingEdit;
    this.pendingEdit = null;
    const before: Change = { documents: { [name]: session.documents.own(name) ?? null } };
    this.isStoring = true;
    session.documents.put(name, text.toString());
    this.isStoring = false;
    if (text === this.editorFile.doc && !session.documents.isUnsaved(name)) this.editorFile.saved();
    if (session.setup.program === "" && this.isProgram) {
      before.setup = { program: "" };
      session.change({ program: name });
    }
    session.history.recordChange(texts.code.typed(baseName(name)), before, kind && `${kind} ${name}`);
  }

  // Another part of the page replaced the text, for example by a dropped file or an undo. Unchanged parts
  // stay, and the editor's own undo continues.
  private replaced(name: string): void {
    if (this.isStoring) return;
    if (name === this.session.setup.machine) this.refresh();
    const editorFile = this.editorFiles.get(name);
    if (!editorFile) return;
    const { documents } = this.session;
    // It may have been saved, or removed, during typing.
    if (name === this.name) this.flush();
    if (documents.get(name) === undefined && name !== UNTITLED) {
      this.editorFiles.delete(name);
      if (name === this.name) this.show(this.has(name) ? name : this.session.setup.program);
      return;
    }
    this.rewrite(editorFile, documents.text(name));
    // The text was not in the page before.
    if (name === this.name && editorFile.state.readOnly && !this.readOnly) this.refresh();
    if (!documents.isUnsaved(name)) editorFile.saved();
    if (name === this.name) this.events.onEdit();
  }

  private rewrite(editorFile: EditorFile, text: string): void {
    const change = textChange(editorFile.doc, text);
    if (!change) return;
    const transaction = editorFile.state.update({ changes: change, annotations: [programmaticEdit.of(true), isolateHistory.of("full")] });
    if (editorFile === this.editorFile) this.editor.view.dispatch(transaction);
    else editorFile.state = transaction.state;
    editorFile.changed(transaction.changes.desc);
    if (editorFile === this.editorFile) this.modal.changed(editorFile.doc.lineAt(change.from).number);
  }
}

// Read-only view of the program as Lua, next to it or instead of it. Line n of the G-code is line n + 1 here.

import { element } from "../core/dom";
import type { Session } from "../core/session";
import type { Store } from "../core/store";
import { texts } from "../texts";
import { Editor, programmaticEdit } from "./editor";
import { hover } from "./hover";
import { luaLanguage } from "./lua_language";
import type { SourcePane } from "./source_pane";

export interface TranslationEvents {
  /** Handles a chosen line of the G-code. */
  onLineSelected(line: number): void;
  run(): void;
  leave(): void;
  edit(): void;
  /** Another translation is shown. */
  onDisplayed(): void;
}

/** Offset of the lines of the G-code in the Lua. */
export const OFFSET_LINES = 1;

/** First line of a translation, which belongs to no block. */
const HEADER_LINE = 1;

export class TranslationPane {
  readonly editor: Editor;
  /** Translation; "": none. */
  script = "";
  private readonly note = element("span", { class: "code-grow" });
  private readonly edit: HTMLButtonElement;
  private asked = 0;
  private isStale = true;

  constructor(
    host: HTMLElement,
    private readonly store: Store,
    private readonly session: Session,
    private readonly source: SourcePane,
    private readonly events: TranslationEvents,
  ) {
    const attributes = { type: "button", title: texts.code.editLuaTitle, onclick: () => events.edit() };
    this.edit = element("button", attributes, texts.code.editLua);
    const body = element("div", { class: "code-body" });
    // The strip is below the editor, so that lines of both are at the same height.
    host.append(body, element("div", { class: "code-strip", role: "status" }, this.note, this.edit));
    this.editor = new Editor(
      body,
      {
        onUpdate: (update) => {
          if (update.transactions.some((transaction) => transaction.annotation(programmaticEdit))) return;
          if (update.selectionSet) this.choose(update.state.doc.lineAt(update.state.selection.main.head).number);
        },
        onGutterClick: (line) => {
          this.editor.select(line);
          this.choose(line);
        },
        run: () => events.run(),
        leave: () => events.leave(),
      },
    );
    this.show("");
  }

  /** Marks the shown translation as one of an earlier text. */
  markStale(): void {
    this.isStale = true;
    ++this.asked;
  }

  /** Another program is shown. */
  clear(): void {
    this.markStale();
    this.show("");
  }

  /** Requests the translation if the shown one is not of the present text. */
  async refresh(): Promise<void> {
    if (!this.isStale || this.source.isScript || !this.session.canRun || this.source.isNotLoaded) return this.showMessage();
    this.isStale = false;
    const asked = ++this.asked;
    this.note.textContent = texts.code.translating;
    this.source.flush();
    const script = await this.session.translate(this.source.name);
    if (asked !== this.asked) return;
    if (script !== null) this.show(script);
    this.showMessage(script === null);
    this.events.onDisplayed();
  }

  private showMessage(failed = false): void {
    const { code } = texts;
    if (!this.session.canRun) this.note.textContent = code.noEngine;
    else if (this.source.isNotLoaded) this.note.textContent = texts.folder.notTranslated;
    else if (failed) this.note.textContent = this.script ? code.translationOld : code.translationFailed;
    else this.note.textContent = code.translation;
    this.edit.hidden = failed || !this.script;
  }

  private choose(line: number): void {
    if (line > HEADER_LINE) this.events.onLineSelected(line - OFFSET_LINES);
  }

  private show(script: string): void {
    const { scrollTop } = this.editor.view.scrollDOM;
    this.script = script;
    const configuration = {
      language: [
        luaLanguage(this.source.dialect),
        hover({
          store: this.store,
          dialect: () => this.source.dialect,
          runLocation: (line) => this.source.runLocation(line - OFFSET_LINES),
          modal: (line) => this.source.modalAt(line - OFFSET_LINES),
          isLua: true,
        }),
      ],
      readOnly: true,
      label: texts.code.translationLabel(this.source.name),
      hint: "",
    };
    this.editor.show(this.editor.stateOf(script, configuration));
    this.editor.view.scrollDOM.scrollTop = scrollTop;
    this.edit.hidden = !script;
  }
}

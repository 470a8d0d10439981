// Row above a form: its file, the text of it, and a button to save it.

import { element } from "../../core/dom";
import { shortName } from "../../core/kinds";
import { isTomlFile } from "../../core/references";
import type { EngineDiagnostic } from "../../run/run";
import { texts } from "../../texts";
import type { FileRole } from "./file/model";
import type { Context } from "./form/context";
import { ErrorList } from "./sections/error_list";

const words = texts.machine;

export class FileRow {
  readonly element: HTMLElement;
  private readonly name = element("b", {});
  private readonly about = element("span", { class: "note" });
  private readonly faults: ErrorList;
  private told: EngineDiagnostic[] = [];

  constructor(
    private readonly context: Context,
    private readonly part: FileRole,
    ...more: HTMLElement[]
  ) {
    const { edits, session, store } = context;
    this.faults = new ErrorList((file, line) => store.set("textAsked", { file, line }));
    const showText = async () => store.set("textAsked", { file: await edits.own(part), line: 1 });
    const save = async () => {
      await session.save(await edits.untilSettled(part));
      this.draw();
    };
    const buttons = [
      element("button", { type: "button", title: words.asTextHint, onclick: () => void showText() }, words.showText),
      element("button", { type: "button", title: words.saveHint, onclick: () => void save() }, words.save),
      ...more,
    ];
    const title = element("p", { class: "file" }, this.name, " ", this.about);
    this.element = element("div", { class: "file-row" }, title, element("div", { class: "buttons" }, ...buttons), this.faults.element);
  }

  /** Shows the results of the check for all files. */
  tell(faults: EngineDiagnostic[]): void {
    this.told = faults;
    this.draw();
  }

  draw(): void {
    const { model, session } = this.context;
    const loaded = model.parts.get(this.part);
    const file = loaded?.file ?? "";
    const isOwn = session.documents.isOwn(file);
    this.name.textContent = shortName(file);
    this.name.title = file;
    const unsavedNote = session.documents.isUnsaved(file) ? words.unsaved : "";
    this.about.textContent = !isTomlFile(file) ? words.settings : isOwn ? unsavedNote : words.sample;
    const own = loaded?.fault ? [loaded.fault] : [];
    const others = this.told.filter(({ text }) => !own.some((fault) => fault.text === text));
    this.faults.show([...own, ...others]);
  }
}

// Row above a form: its file, the text of it, and a button to save it.

import { element } from "../../core/dom";
import { shortName } from "../../core/file_kinds";
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
  private readonly errors: ErrorList;
  private diagnostics: EngineDiagnostic[] = [];

  constructor(
    private readonly context: Context,
    private readonly part: FileRole,
    ...more: HTMLElement[]
  ) {
    const { edits, session, store } = context;
    this.errors = new ErrorList((file, line) => store.set("requestedLocation", { file, line }));
    const showText = async () => store.set("requestedLocation", { file: await edits.own(part), line: 1 });
    const save = async () => {
      await session.save(await edits.untilSettled(part));
      this.draw();
    };
    const buttons = [
      element("button", { type: "button", title: words.editAsTextHint, onclick: () => void showText() }, words.showText),
      element("button", { type: "button", title: words.saveHint, onclick: () => void save() }, words.save),
      ...more,
    ];
    const title = element("p", { class: "file" }, this.name, " ", this.about);
    this.element = element("div", { class: "file-row" }, title, element("div", { class: "buttons" }, ...buttons), this.errors.element);
  }

  /** Shows the results of the check for all files. */
  setDiagnostics(errors: EngineDiagnostic[]): void {
    this.diagnostics = errors;
    this.draw();
  }

  draw(): void {
    const { model, session } = this.context;
    const loaded = model.parts.get(this.part);
    const file = loaded?.file ?? "";
    const isUserFile = session.documents.isUserFile(file);
    this.name.textContent = shortName(file);
    this.name.title = file;
    const unsavedNote = session.documents.isUnsaved(file) ? words.unsaved : "";
    this.about.textContent = !isTomlFile(file) ? words.settings : isUserFile ? unsavedNote : words.sample;
    const own = loaded?.error ? [loaded.error] : [];
    const others = this.diagnostics.filter(({ text }) => !own.some((error) => error.text === text));
    this.errors.show([...own, ...others]);
  }
}

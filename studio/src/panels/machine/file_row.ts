// Row above a form: its file, the text of it, and a button to save it.

import { element } from "../../core/dom";
import { shortName } from "../../core/kinds";
import { isFile } from "../../core/references";
import type { Told } from "../../run/run";
import { texts } from "../../texts";
import type { Part } from "./file/model";
import type { Context } from "./form/context";
import { Faults } from "./sections/faults";

const words = texts.machine;

export class FileRow {
  readonly element: HTMLElement;
  private readonly name = element("b", {});
  private readonly about = element("span", { class: "note" });
  private readonly faults: Faults;
  private told: Told[] = [];

  constructor(
    private readonly context: Context,
    private readonly part: Part,
    ...more: HTMLElement[]
  ) {
    const { edits, session, store } = context;
    this.faults = new Faults((file, line) => store.set("textAsked", { file, line }));
    const asText = async () => store.set("textAsked", { file: await edits.own(part), line: 1 });
    const save = async () => {
      await session.save(await edits.settled(part));
      this.draw();
    };
    const buttons = [
      element("button", { type: "button", title: words.asTextHint, onclick: () => void asText() }, words.asText),
      element("button", { type: "button", title: words.saveHint, onclick: () => void save() }, words.save),
      ...more,
    ];
    const title = element("p", { class: "file" }, this.name, " ", this.about);
    this.element = element("div", { class: "file-row" }, title, element("div", { class: "buttons" }, ...buttons), this.faults.element);
  }

  /** Shows the results of the check for all files. */
  tell(faults: Told[]): void {
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
    const ofOwn = session.documents.isUnsaved(file) ? words.unsaved : "";
    this.about.textContent = !isFile(file) ? words.settings : isOwn ? ofOwn : words.sample;
    const own = loaded?.fault ? [loaded.fault] : [];
    const others = this.told.filter(({ text }) => !own.some((fault) => fault.text === text));
    this.faults.show([...own, ...others]);
  }
}

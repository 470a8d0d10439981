// Machine data: a list of the data that a controller stores, and the entries of the chosen section.

import "./data.css";
import { choice, element, setOptions } from "../../core/dom";
import { namesOfKind, shortName } from "../../core/file_kinds";
import { openFileDialog } from "../../core/files";
import type { Session } from "../../core/session";
import type { Store } from "../../core/store";
import { texts } from "../../texts";
import type { PanelForm } from "../form";
import { lengthUnit, type DataResult, type Data, type DataChange, type Entry, type LengthUnit, type Section } from "./data_request";
import { DataFile } from "./data_file";
import { EntryDialog } from "./entry_dialog";
import { createProblems } from "./problems";
import { EntryTable } from "./table";

const words = texts.data;

const button = (text: string, title: string, act: () => void): HTMLButtonElement =>
  element("button", { title, onclick: () => void act() }, text);

/** The control keeps the focus: so it is not disabled, but does nothing. */
const allow = (control: HTMLElement, on: boolean): void => control.setAttribute("aria-disabled", String(!on));

class DataForm implements PanelForm {
  private readonly file: DataFile;
  private readonly files = choice(words.file, [], "", (name) => this.chooseFile(name));
  private readonly sections = choice(words.section, [], "", () => this.showSection());
  private readonly table = new EntryTable({
    edit: () => this.edit(),
    reset: () => this.reset(),
    chosen: () => this.updateButtons(),
    onEmptied: () => this.addButton.focus(),
    unit: (entry) => this.toggleUnit(entry),
  });
  private readonly problems = createProblems();
  private readonly saveButton = button(words.save, "", () => void this.save());
  private readonly editButton = button(words.edit, words.editHint, () => this.edit());
  private readonly addButton = button(words.add, "", () => this.add());
  private readonly resetButton = button(words.reset, words.resetHint, () => this.reset());
  private readonly resetAllButton = button(words.resetAll, "", () => this.resetAll());
  private readonly convertButtons: HTMLButtonElement[];
  private readonly content: HTMLElement;
  readonly element: HTMLElement;
  private data: Data | null = null;
  /** File of the shown data. */
  private shownName = "";
  private isVisible = false;
  private requestNumber = 0;

  constructor(
    private readonly store: Store,
    private readonly session: Session,
  ) {
    this.file = new DataFile(session);
    this.files.title = words.fileHint;
    this.sections.className = "data-section";
    const convert = (unit: LengthUnit) => button(unit, words.convertHint(unit), () => this.convert(unit));
    this.convertButtons = [convert("mm"), convert("inch")];
    this.content = element(
      "div",
      {},
      this.sections,
      this.table.element,
      element("div", { class: "buttons" }, this.editButton, this.addButton, this.resetButton, this.resetAllButton),
      element("div", { class: "buttons", role: "group", "aria-label": words.convert }, words.convert, ...this.convertButtons),
    );
    this.element = element(
      "div",
      { class: "data-form" },
      element("div", { class: "buttons" }, this.files, button(words.open, words.openHint, () => this.open()), this.saveButton),
      this.content,
      this.problems.element,
    );
    session.on(() => this.refresh());
    session.documents.on((name) => this.documentChanged(name));
  }

  onDisplayed(): void {
    this.isVisible = true;
    this.refresh();
  }

  onHidden(): void {
    this.isVisible = false;
  }

  private documentChanged(name: string): void {
    const { machine, cell } = this.session.setup;
    const { documents } = this.session;
    const isDataFile = documents.get(name) === undefined || documents.kindOf(name) === "machine_data";
    if (isDataFile || [this.file.name, machine, cell].includes(name)) this.refresh();
  }

  private refresh(): void {
    if (this.isVisible) void this.ask();
  }

  private async ask(): Promise<void> {
    const requestNumber = ++this.requestNumber;
    const { name } = this.file;
    const response = await this.file.read();
    // A later request has the later data.
    if (requestNumber !== this.requestNumber) return;
    this.shownName = name;
    this.show(response);
  }

  private show(response: DataResult): void {
    this.showFiles();
    this.data = response.data;
    this.content.hidden = !response.data;
    this.problems.show(response.diagnostics, this.errorOf(response));
    if (!response.data) return;
    const options = response.data.sections.map(({ name, title }): [string, string] => [name, title]);
    setOptions(this.sections, options, this.sections.value || options[0][0]);
    this.showSection();
  }

  /**
   * Returns the error to show. Errors in lines of the file are listed separately; others come from the
   * machine or the cell.
   */
  private errorOf(response: DataResult): string {
    if (response.data) return "";
    return response.diagnostics.length > 0 ? words.unreadable(this.file.name) : response.refusal;
  }

  private showFiles(): void {
    const { file, session } = this;
    const names = namesOfKind("machine_data", session.documents);
    if (!file.isNew && !names.includes(file.name)) names.push(file.name);
    const options = names.map((name): [string, string] => [name, shortName(name)]);
    setOptions(this.files, [["", words.newFile(file.newName)], ...options], session.setup.machine_data);
    for (const each of [this.saveButton, ...this.convertButtons]) allow(each, !file.isNew);
    this.saveButton.title = file.isNew ? words.nothingToSave : words.saveHint(shortName(file.name));
  }

  /**
   * Returns undefined if nothing can be changed, or if other data have been chosen and are not loaded yet.
   */
  private get section(): Section | undefined {
    if (this.shownName !== this.file.name) return undefined;
    return this.data?.sections.find(({ name }) => name === this.sections.value);
  }

  private showSection(): void {
    const { section } = this;
    if (!section) return;
    this.addButton.title = words.addHint(section.id);
    this.resetAllButton.title = words.resetAllHint(section.title);
    this.table.show(section, this.data?.entries[section.name] ?? []);
  }

  private updateButtons(): void {
    const buttons = [this.editButton, this.resetButton, this.resetAllButton];
    for (const each of buttons) allow(each, this.table.chosen !== undefined);
  }

  /** Shows an error in the notice line of the page if no dialog is open. */
  private async make(label: string, change: DataChange): Promise<void> {
    const refusal = await this.file.change(label, change);
    if (refusal) this.store.set("notice", refusal);
  }

  private chooseFile(name: string): void {
    this.session.history.edit(words.steps.choice(name ? shortName(name) : words.none), { setup: { machine_data: name } });
  }

  private open(): void {
    openFileDialog(false, ([file]) => {
      void file.arrayBuffer().then((bytes) => {
        const refusal = this.file.accept(file.name, new Uint8Array(bytes));
        this.store.set("notice", refusal);
      });
    });
  }

  private async save(): Promise<void> {
    const { name } = this.file;
    await this.file.untilSettled();
    if (this.session.documents.get(name) !== undefined) await this.session.save(name);
  }

  private edit(): void {
    const { section } = this;
    const entry = this.table.chosen;
    if (!section || !entry) return;
    const dialog = new EntryDialog(section, entry, "metric", {
      make: (change) => this.file.change(words.steps.set(section.name, entry.id), change),
      findError: (change) => this.file.findError(change),
    });
    dialog.open();
  }

  private add(): void {
    const { section } = this;
    if (!section) return;
    const dialog = new EntryDialog(section, null, this.store.get("units") === "inch" ? "inch" : "metric", {
      make: async (change) => {
        const refusal = await this.file.change(words.steps.added(section.name, change.id), change, true);
        if (!refusal) this.table.choose(change.id);
        return refusal;
      },
      findError: (change) => this.file.findError(change, true),
    });
    dialog.open();
  }

  private reset(): void {
    const { section } = this;
    const id = this.table.chosen?.id;
    if (!section || id === undefined) return;
    void this.make(words.steps.reset(section.name, id), { op: "reset", section: section.name, id });
  }

  private resetAll(): void {
    const { section } = this;
    if (!section || !this.table.chosen) return;
    void this.make(words.steps.resetAll(section.name), { op: "reset_all", section: section.name });
  }

  private toggleUnit(entry: Entry): void {
    const { section } = this;
    if (!section || !entry.unit) return;
    const unit = lengthUnit(entry.unit === "inch" ? "metric" : "inch");
    const change: DataChange = { op: "set", section: section.name, id: entry.id, values: {}, unit };
    void this.make(words.steps.unit(section.name, entry.id, unit), change);
  }

  private convert(unit: LengthUnit): void {
    if (!this.file.isNew) void this.make(words.steps.convert(unit), { op: "convert", unit });
  }
}

export const createData = (store: Store, session: Session): PanelForm => new DataForm(store, session);

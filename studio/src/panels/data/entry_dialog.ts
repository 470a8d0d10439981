// Dialog for an entry: a field for each value, and the unit of its lengths. An error of the engine is shown
// at the field that it is about.

import { element } from "../../core/dom";
import { texts } from "../../texts";
import { lengthUnit, type SetEntry, type Entry, type EntryUnit, type Section } from "./data_request";
import { ValueField } from "./entry_fields";

const words = texts.data;

export interface EntryEvents {
  /** Makes the change; returns an error message, or an empty text. */
  make(change: SetEntry): Promise<string>;
  /** Returns why a change is not possible, or an empty text; changes nothing. */
  findError(change: SetEntry): Promise<string>;
}

export class EntryDialog {
  private readonly id: ValueField;
  private readonly fields: ValueField[];
  private readonly error = element("p", { class: "fault", role: "alert", hidden: true });
  private readonly dialog: HTMLDialogElement;
  private unit: EntryUnit;
  private isRequestPending = false;

  /** `entry` is null for a new entry; its lengths are initially in `unit`. */
  constructor(
    private readonly section: Section,
    private readonly entry: Entry | null,
    unit: EntryUnit,
    private readonly events: EntryEvents,
  ) {
    this.unit = entry?.unit ?? unit;
    const id = { name: words.entryId, unit: "none", meaning: section.id, required: true } as const;
    this.id = new ValueField(id, null, "data-entry-id");
    this.fields = section.fields.map((field) => new ValueField(field, entry, `data-entry-${field.name}`));
    const title = entry ? words.entry(section.title, entry.id) : words.entryNew(section.title);
    const form = element(
      "form",
      { method: "dialog", onsubmit: (event) => (event.preventDefault(), void this.submit()) },
      element("h2", {}, title),
      ...(entry ? [] : [this.id.element]),
      ...(section.has_unit ? [this.units()] : []),
      element("div", { class: "values" }, ...this.fields.map((field) => field.element)),
      this.error,
      element(
        "div",
        { class: "buttons" },
        element("button", { class: "primary", type: "submit" }, words.ok),
        element("button", { type: "button", onclick: () => this.dialog.close() }, words.cancel),
      ),
    );
    const attributes = { class: "data-entry", "aria-label": title, onclose: () => this.dialog.remove() };
    this.dialog = element("dialog", attributes, form);
    this.showValues();
  }

  open(): void {
    document.body.append(this.dialog);
    this.dialog.showModal();
    const { input } = this.entry ? this.fields[0] : this.id;
    input.focus();
    if (input instanceof HTMLInputElement) input.select();
  }

  private units(): HTMLElement {
    const radio = (unit: EntryUnit) => {
      const input = element("input", {
        type: "radio",
        name: "data-entry-unit",
        checked: unit === this.unit,
        onchange: () => {
          this.unit = unit;
          this.showValues();
        },
      });
      return element("label", {}, input, words.units[unit]);
    };
    return element("fieldset", {}, element("legend", {}, words.lengthsIn), radio("metric"), radio("inch"));
  }

  private showValues(): void {
    for (const field of this.fields) field.show(this.unit);
  }

  private change(values: Record<string, string>): SetEntry {
    const { section, entry, unit } = this;
    const id = entry?.id ?? this.id.changed ?? "";
    return { op: "set", section: section.name, id, values, ...(section.has_unit ? { unit: lengthUnit(unit) } : {}) };
  }

  private async submit(): Promise<void> {
    if (this.isRequestPending) return;
    if (!this.entry && this.id.changed === undefined) return this.refuse(this.id, words.noId);
    this.isRequestPending = true;
    const changed = this.fields.filter((field) => field.changed !== undefined);
    const values = Object.fromEntries(changed.map((field) => [field.name, field.changed!]));
    const refusal = await this.events.make(this.change(values));
    if (!refusal) this.dialog.close();
    else this.refuse(await this.findInvalidField(changed, refusal), refusal);
    this.isRequestPending = false;
  }

  /**
   * Returns the field that caused an error: the one that alone gives this error, or that it names; null:
   * several together.
   */
  private async findInvalidField(changed: ValueField[], refusal: string): Promise<ValueField | null> {
    const isErrorOf = async (values: Record<string, string>) => (await this.events.findError(this.change(values))) === refusal;
    const isErrorOfAny = !this.entry && (await isErrorOf({}));
    for (const field of isErrorOfAny ? [] : changed) if (await isErrorOf({ [field.name]: field.changed! })) return field;
    return this.fields.find((field) => field.isNamedIn(refusal)) ?? (isErrorOfAny ? this.id : null);
  }

  /** Shows an error at a field, or below all fields. */
  private refuse(at: ValueField | null, why: string): void {
    for (const field of [this.id, ...this.fields]) field.refuse(field === at ? why : "");
    this.error.textContent = at ? "" : why;
    this.error.hidden = at !== null;
    at?.input.focus();
  }
}

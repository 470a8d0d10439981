// The values of an entry in a dialog: a field for each, with its unit and its meaning; only what a person has changed is
// told.

import { choice, element } from "../../core/dom";
import { length, mmOf } from "../../core/units";
import { texts } from "../../texts";
import type { Entry, EntryUnit, Field } from "./asked";

const words = texts.data;

/** A length of one unit in the other, with the digits that a file would have. */
function converted(value: number, from: EntryUnit, to: EntryUnit): string {
  if (from === to) return String(value);
  return String(Number((to === "inch" ? length(value, "inch") : mmOf(value, "inch")).toPrecision(15)));
}

/** A value of an entry, to be changed. */
export class ValueField {
  readonly element: HTMLElement;
  readonly input: HTMLInputElement | HTMLSelectElement;
  private readonly unit = element("span", { class: "unit" });
  private readonly fault = element("p", { class: "fault", role: "alert" });
  /** As it stands in the file. */
  private shown: string;

  constructor(
    private readonly field: Field,
    private readonly entry: Entry | null,
    id: string,
  ) {
    const { name, choices } = field;
    this.fault.id = `${id}-fault`;
    const options = choices?.map((each): [string, string] => [each, each || words.none]);
    this.input = options ? choice(name, options, "", () => {}) : element("input", { type: "text", autocomplete: "off" });
    this.input.id = id;
    this.shown = this.input.value;
    const hint = element("small", { id: `${id}-hint` }, field.meaning);
    this.input.setAttribute("aria-describedby", `${hint.id} ${this.fault.id}`);
    this.element = element(
      "div",
      { class: "value" },
      element("label", { for: id }, name),
      element("span", { class: "with-unit" }, this.input, this.unit),
      hint,
      this.fault,
    );
    this.refuse("");
  }

  get name(): string {
    return this.field.name;
  }

  /** "Xmin is 10" names XMIN; single letters are capitals. */
  isNamedIn(sentence: string): boolean {
    return new RegExp(`\\b${this.name}\\b`, this.name.length > 1 ? "i" : "").test(sentence);
  }

  /** What was typed; undefined: it is as it stands in the file. */
  get changed(): string | undefined {
    const text = this.input.value.trim();
    return text === this.shown ? undefined : text;
  }

  /** Shows it in a unit. What was typed stays as it is: it is meant in that unit. */
  show(unit: EntryUnit): void {
    const { field, entry } = this;
    const isTyped = this.changed !== undefined;
    const value = entry?.[field.name];
    if (value === null) this.shown = "-";
    else if (value === undefined) this.shown = field.choices?.[0] ?? "";
    else if (typeof value === "number" && field.unit === "length") this.shown = converted(value, entry?.unit ?? unit, unit);
    else this.shown = String(value);
    if (!isTyped) this.input.value = this.shown;
    this.unit.textContent = field.unit === "length" ? words.units[unit] : field.unit === "angle" ? words.angle : "";
  }

  /** Shows why the value cannot be; empty: it can. */
  refuse(why: string): void {
    this.fault.textContent = why;
    this.fault.hidden = !why;
    this.input.setAttribute("aria-invalid", String(why !== ""));
  }
}

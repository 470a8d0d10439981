// Values of an entry in a dialog: a field for each, with its unit and its meaning. Only values that the user
// has changed are passed on.

import { choice, element } from "../../core/dom";
import { length, toMm } from "../../core/units";
import { texts } from "../../texts";
import type { Entry, EntryUnit, Field } from "./data_request";

const words = texts.data;

/** Converts a length from one unit to the other, with the digits that a file would have. */
function converted(value: number, from: EntryUnit, to: EntryUnit): string {
  if (from === to) return String(value);
  return String(Number((to === "inch" ? length(value, "inch") : toMm(value, "inch")).toPrecision(15)));
}

/** Value of an entry that can be changed. */
export class ValueField {
  readonly element: HTMLElement;
  readonly input: HTMLInputElement | HTMLSelectElement;
  private readonly unit = element("span", { class: "unit" });
  private readonly error = element("p", { class: "fault", role: "alert" });
  /** Value as in the file. */
  private displayed: string;

  constructor(
    private readonly field: Field,
    private readonly entry: Entry | null,
    id: string,
  ) {
    const { name, choices } = field;
    this.error.id = `${id}-fault`;
    const options = choices?.map((each): [string, string] => [each, each || words.none]);
    this.input = options ? choice(name, options, "", () => {}) : element("input", { type: "text", autocomplete: "off" });
    this.input.id = id;
    this.displayed = this.input.value;
    const hint = element("small", { id: `${id}-hint` }, field.meaning);
    this.input.setAttribute("aria-describedby", `${hint.id} ${this.error.id}`);
    this.element = element(
      "div",
      { class: "value" },
      element("label", { for: id }, name),
      element("span", { class: "with-unit" }, this.input, this.unit),
      hint,
      this.error,
    );
    this.refuse("");
  }

  get name(): string {
    return this.field.name;
  }

  /** True for a message such as "Xmin is 10", which names XMIN; single letters are capitals. */
  isNamedIn(sentence: string): boolean {
    return new RegExp(`\\b${this.name}\\b`, this.name.length > 1 ? "i" : "").test(sentence);
  }

  /** Returns the typed text; undefined if it is the value of the file. */
  get changed(): string | undefined {
    const text = this.input.value.trim();
    return text === this.displayed ? undefined : text;
  }

  /** Shows the value in a unit. Typed text stays as it is, because it is meant in that unit. */
  show(unit: EntryUnit): void {
    const { field, entry } = this;
    const isChanged = this.changed !== undefined;
    const value = entry?.[field.name];
    if (value === null) this.displayed = "-";
    else if (value === undefined) this.displayed = field.choices?.[0] ?? "";
    else if (typeof value === "number" && field.unit === "length") this.displayed = converted(value, entry?.unit ?? unit, unit);
    else this.displayed = String(value);
    if (!isChanged) this.input.value = this.displayed;
    this.unit.textContent = field.unit === "length" ? words.units[unit] : field.unit === "angle" ? words.angle : "";
  }

  /** Shows an error of the value; empty: none. */
  refuse(why: string): void {
    this.error.textContent = why;
    this.error.hidden = !why;
    this.input.setAttribute("aria-invalid", String(why !== ""));
  }
}

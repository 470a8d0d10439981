// Fields of a form that are updated in place, so that a user does not lose the typed text.

import { choice, element, setOptions } from "../../core/dom";
import type { Units } from "../../core/store";
import { length, lengthUnit, toMm } from "../../core/units";
import { texts } from "../../texts";

export type Quantity = "length" | "feed" | "acceleration" | "angle" | "turning" | "per_turn" | "time" | "none";

const words = texts.paths.form;
const lengthQuantities: Quantity[] = ["length", "feed", "acceleration", "per_turn"];

export function unitText(quantity: Quantity, units: Units): string {
  const mm = lengthUnit(units);
  const all: Record<Quantity, string> = {
    length: mm,
    feed: `${mm}/min`,
    acceleration: `${mm}/s²`,
    angle: "°",
    turning: "°/min",
    per_turn: mm,
    time: "s",
    none: "",
  };
  return all[quantity];
}

/** Returns a number with as many digits as matter, without trailing zeros. */
export function numberText(value: number, quantity: Quantity, units: Units): string {
  const displayed = lengthQuantities.includes(quantity) ? length(value, units) : value;
  return String(Number(displayed.toFixed(units === "inch" ? 5 : 4)));
}

/** Returns null if the text is not a number, undefined if it is empty. */
export function parseNumber(text: string, quantity: Quantity, units: Units): number | null | undefined {
  const plain = text.trim().replace(",", ".");
  if (plain === "") return undefined;
  const value = Number(plain);
  if (!Number.isFinite(value)) return null;
  return lengthQuantities.includes(quantity) ? toMm(value, units) : value;
}

export interface FieldValue {
  value: number | undefined;
  /** Value that applies if the field is empty. */
  inherited?: number | undefined;
}

/** Input for a number; undefined if it was emptied. */
export class NumberInput {
  readonly element: HTMLInputElement;
  private units: Units = "mm";
  private text = "";

  constructor(
    private readonly label: string,
    private readonly quantity: Quantity,
    private readonly change: (value: number | undefined) => void,
  ) {
    this.element = element("input", { class: "number", inputmode: "decimal", autocomplete: "off", onchange: () => this.applyInput() });
  }

  private applyInput(): void {
    const value = parseNumber(this.element.value, this.quantity, this.units);
    this.element.setAttribute("aria-invalid", String(value === null));
    this.element.title = value === null ? words.noNumber : "";
    if (value === null || this.element.value.trim() === this.text) return;
    this.change(value);
  }

  show({ value, inherited }: FieldValue, units: Units): void {
    const { element: input, label, quantity } = this;
    this.units = units;
    const text = value === undefined ? "" : numberText(value, quantity, units);
    input.placeholder = inherited === undefined ? "" : numberText(inherited, quantity, units);
    const unit = unitText(quantity, units);
    const name = unit ? `${label}, ${unit}` : label;
    input.setAttribute("aria-label", value === undefined && inherited !== undefined ? words.inherited(name, input.placeholder) : name);
    // Text that is being typed stays, unless the document has another value by now.
    if (document.activeElement === input && text === this.text) return;
    this.text = text;
    input.value = text;
    input.setAttribute("aria-invalid", "false");
    input.title = "";
  }
}

/** Creates a row with a name and its parts. */
export const row = (label: string, ...parts: (Node | string)[]): HTMLElement =>
  element("div", { class: "field" }, element("span", { class: "field-name" }, label), element("span", { class: "field-parts" }, ...parts));

/** Number with its name and unit. */
export class NumberRow {
  readonly element: HTMLElement;
  private readonly input: NumberInput;
  private readonly unit = element("span", { class: "unit" });

  constructor(
    label: string,
    private readonly quantity: Quantity,
    change: (value: number | undefined) => void,
  ) {
    this.input = new NumberInput(label, quantity, change);
    this.element = row(label, this.input.element, this.unit);
  }

  show(displayed: FieldValue, units: Units): void {
    this.input.show(displayed, units);
    this.unit.textContent = unitText(this.quantity, units);
  }
}

/** Several numbers in a row: a point, a direction, angles of axes. */
export class NumbersRow {
  readonly element: HTMLElement;
  private readonly inputs: NumberInput[];
  private readonly name: Element;
  private values: (number | undefined)[] = [];

  constructor(
    private readonly label: string,
    names: readonly string[],
    private readonly quantity: Quantity,
    change: (values: (number | undefined)[]) => void,
  ) {
    this.inputs = names.map(
      (name, i) => new NumberInput(`${label} ${name}`, quantity, (value) => change(this.values.map((each, k) => (k === i ? value : each)))),
    );
    this.element = row(label, ...this.inputs.map(({ element: input }, i) => element("label", {}, names[i], input)));
    this.element.classList.add("several");
    this.name = this.element.querySelector(".field-name")!;
  }

  show(values: readonly (number | undefined)[], units: Units, inherited: readonly (number | undefined)[] = []): void {
    this.values = [...values];
    this.inputs.forEach((input, i) => input.show({ value: values[i], inherited: inherited[i] }, units));
    const unit = unitText(this.quantity, units);
    this.name.textContent = unit ? `${this.label}, ${unit}` : this.label;
  }
}

/** Choice between words, updated in place. */
export class ChoiceRow<Value extends string> {
  readonly element: HTMLElement;
  private readonly select: HTMLSelectElement;

  constructor(label: string, options: readonly (readonly [Value, string])[], change: (value: Value) => void) {
    this.select = choice(label, options, "", (value) => change(value as Value));
    this.element = row(label, this.select);
  }

  show(value: Value): void {
    this.select.value = value;
  }

  /** Sets new options and the value. */
  setOptions(options: readonly (readonly [Value, string])[], value: Value): void {
    setOptions(this.select, options, value);
  }
}

/** Line of text; its value is passed on when the field is left. */
export class TextRow {
  readonly element: HTMLElement;
  readonly input: HTMLInputElement;
  private text = "";

  constructor(label: string, change: (text: string) => void) {
    this.input = element("input", {
      class: "text",
      "aria-label": label,
      autocomplete: "off",
      onchange: () => {
        if (this.input.value !== this.text) change(this.input.value);
      },
    });
    this.element = row(label, this.input);
  }

  show(text: string, placeholder = ""): void {
    this.input.placeholder = placeholder;
    if (document.activeElement === this.input && text === this.text) return;
    this.text = text;
    this.input.value = text;
  }
}

// One value of a file, to view and change. Typed text stays until it is passed on; the value of the file can
// change at any time.

import { element, setOptions } from "../../../core/dom";
import type { Store } from "../../../core/store";
import { texts } from "../../../texts";
import type { Toml } from "../file/toml";
import type { Range } from "./key_schema";
import { parseNumber, numberText, unitText } from "./quantity";

const words = texts.machine.field;

export interface FieldSpec extends Range {
  label: string;
  kind: "number" | "text" | "choice" | "switch" | "list" | "numbers";
  unit?: string;
  /** Purpose of the value; with `showsMeaning` it is shown below, else as a tooltip. */
  meaning?: string;
  showsMeaning?: boolean;
  /** Suggested values; a text may have others. */
  choices?: readonly (readonly [value: string, text: string])[];
  /** It may not be empty. */
  isRequired?: boolean;
  /** Name of its key before this version; the file may still have it. */
  formerly?: string;
  /** True if its label is above it. */
  isNarrow?: boolean;
}

/** Makes the change; undefined removes the key. Returns an empty text, or an error message. */
export type Commit = (value: Toml | undefined) => Promise<string>;

let count = 0;

export class Field {
  readonly element: HTMLElement;
  private readonly control: HTMLInputElement | HTMLSelectElement;
  private readonly unit = element("span", { class: "unit" });
  private readonly error: HTMLElement;
  private value: Toml | undefined;
  private fallback: Toml | undefined;
  private displayed = "";

  constructor(
    private readonly store: Store,
    private spec: FieldSpec,
    private readonly commit: Commit,
  ) {
    const id = `machine-field-${++count}`;
    this.error = element("p", { class: "key-fault", id: `${id}-fault`, role: "alert", hidden: true });
    this.control = this.makeControl(id);
    const label = element("label", { for: id }, spec.label);
    const listedOptions = spec.kind === "text" && spec.choices ? [element("datalist", { id: `${id}-choices` }, ...spec.choices.map(([value]) => element("option", { value })))] : [];
    const meaning = spec.showsMeaning && spec.meaning ? [element("small", { id: `${id}-meaning` }, spec.meaning)] : [];
    const row = element("div", { class: "key-row" }, label, this.control, this.unit);
    this.element = element(
      "div",
      { class: spec.isNarrow ? "key-field narrow" : "key-field" },
      row,
      ...listedOptions,
      ...meaning,
      this.error,
    );
    if (spec.meaning) row.title = spec.meaning;
  }

  private makeControl(id: string): HTMLInputElement | HTMLSelectElement {
    const describedBy = `${id}-fault ${this.spec.showsMeaning ? `${id}-meaning` : ""}`.trim();
    const attributes = { id, "aria-describedby": describedBy, onchange: () => void this.submit(), onkeydown: (event: Event) => this.key(event as KeyboardEvent) };
    if (this.spec.kind === "choice" || this.spec.kind === "switch") return element("select", attributes);
    const inputmode = this.spec.kind === "number" ? "decimal" : "text";
    const list = this.spec.choices ? `${id}-choices` : undefined;
    return element("input", { ...attributes, type: "text", inputmode, list, spellcheck: "false", autocomplete: "off" });
  }

  /** Shows the value of the file, and the default if it has none; also after a change of the page's units. */
  show(value: Toml | undefined, fallback?: Toml): void {
    this.value = value;
    this.fallback = fallback;
    this.draw();
  }

  /** Sets the options of a choice. */
  setOptions(choices: readonly (readonly [value: string, text: string])[]): void {
    this.spec = { ...this.spec, choices };
    this.draw();
  }

  focus(): void {
    this.control.focus();
  }

  private draw(): void {
    const text = this.textOf(this.value);
    this.unit.textContent = this.spec.unit ? unitText(this.spec.unit, this.store.get("units")) : "";
    this.unit.hidden = !this.unit.textContent;
    this.element.toggleAttribute("data-set", this.value !== undefined);
    if (this.control instanceof HTMLSelectElement) {
      setOptions(this.control, this.options(), text);
      return;
    }
    const fallback = this.textOf(this.fallback);
    this.control.placeholder = fallback === "inf" || fallback === "-inf" ? words.unlimited : fallback;
    // Text that a user is typing must not be lost.
    const isWriting = document.activeElement === this.control && this.control.value !== this.displayed;
    if (isWriting && text === this.displayed) return;
    if (this.control.value !== text) this.control.value = text;
    if (text !== this.displayed) this.say("");
    this.displayed = text;
  }

  private textOf(value: Toml | undefined): string {
    const { kind, unit = "" } = this.spec;
    if (value === undefined || value === null) return "";
    if (kind === "number") return numberText(value, unit, this.store.get("units"));
    return Array.isArray(value) ? value.join(", ") : String(value);
  }

  private options(): (readonly [string, string])[] {
    const { kind, choices = [], isRequired } = this.spec;
    const known = kind === "switch" ? ([["true", words.yes], ["false", words.no]] as const) : choices;
    const value = this.textOf(this.value);
    const strange = value && !known.some(([each]) => each === value) ? [[value, value] as const] : [];
    if (isRequired) return [...known, ...strange];
    const fallback = known.find(([each]) => each === this.textOf(this.fallback))?.[1];
    return [["", fallback === undefined ? words.notSaid : words.asElse(fallback)], ...known, ...strange];
  }

  /** Returns the typed value for the file, or an error message if it is not valid. */
  private written(): { value: Toml | undefined } | { error: string } {
    const { kind, unit = "", isRequired } = this.spec;
    const text = this.control.value.trim();
    if (text === "") return isRequired ? { error: words.needed } : { value: undefined };
    if (kind === "switch") return { value: text === "true" };
    const parts = text.split(",").map((each) => each.trim()).filter((each) => each !== "");
    if (kind === "list") return { value: parts };
    if (kind === "numbers") {
      const strange = parts.find((part) => parseNumber(part, unit, "mm") === null);
      return strange === undefined ? { value: parts.map((part) => parseNumber(part, unit, "mm")) } : { error: words.noNumber(strange) };
    }
    if (kind === "text" || kind === "choice") return { value: text };
    const value = parseNumber(text, unit, this.store.get("units"));
    if (value === null) return { error: words.noNumber(text) };
    const error = typeof value === "number" ? this.errorOf(value) : "";
    return error ? { error } : { value };
  }

  private errorOf(value: number): string {
    const { min, above, max, below, or = [], integer, unit = "" } = this.spec;
    const text = (limit: number) => numberText(limit, unit, this.store.get("units"));
    if (or.includes(value)) return "";
    if (integer && !Number.isInteger(value)) return words.whole;
    if (min !== undefined && value < min) return words.atLeast(text(min));
    if (above !== undefined && value <= above) return words.above(text(above));
    if (max !== undefined && value > max) return words.atMost(text(max));
    return below !== undefined && value >= below ? words.below(text(below)) : "";
  }

  private async submit(): Promise<void> {
    const written = this.written();
    if ("error" in written) return this.say(written.error);
    this.say("");
    this.say(await this.commit(written.value));
  }

  private key(event: KeyboardEvent): void {
    if (event.key !== "Escape" || this.control.value === this.displayed || this.control instanceof HTMLSelectElement) return;
    event.preventDefault();
    this.control.value = this.displayed;
    this.say("");
  }

  private say(error: string): void {
    this.error.textContent = error;
    this.error.hidden = !error;
    this.control.setAttribute("aria-invalid", String(error !== ""));
  }
}

// Parts of a variant: a field for each part of its setup.

import { check, choice, element, setOptions } from "../../core/dom";
import { dialectTitles } from "../../core/dialects";
import { dialectOfName, namesOfKind, shortName } from "../../core/file_kinds";
import { controllerNames } from "../../core/controller_override";
import type { Session } from "../../core/session";
import { MAX_OVERRIDE_PERCENT, fileKeys, overrideKeys, type Setup } from "../../core/setup";
import { texts } from "../../texts";
import type { Variant } from "./data/variants_file";
import { startText } from "./variant_texts";

const words = texts.variants;

export interface FieldEvents {
  /** Returns true if the name is possible. */
  rename(name: string): boolean;
  change(what: string, setup: Partial<Setup>): void;
  /** Resets the start of its times to the start of the program. */
  fromStart(): void;
}

/** Field, and its update function. */
interface Field {
  element: HTMLElement;
  show(variant: Variant): void;
}

/** Shows a value. Text that is being typed stays, unless the value has changed meanwhile. */
function showValue(input: HTMLInputElement, value: string): void {
  if (input.dataset.displayed === value) return;
  input.value = input.dataset.displayed = value;
}

const row = (label: string, control: HTMLElement): HTMLElement => element("label", { class: "field" }, element("span", {}, label), control);

export class Fields {
  readonly element: HTMLElement;
  private readonly fields: Field[];

  constructor(
    private readonly session: Session,
    private readonly events: FieldEvents,
  ) {
    const [program, machine, ...files] = fileKeys;
    const [feed, ...overrides] = overrideKeys;
    const main = [
      this.name(),
      this.from(),
      this.file(program),
      this.file(machine),
      this.choice("controller", () => [["", words.fromMachineFile], ...controllerNames(session.documents).map(fileOption)]),
      this.override(feed),
    ];
    const rare = [
      ...overrides.map((key) => this.override(key)),
      ...files.map((key) => this.file(key)),
      this.choice("dialect", () => [["", words.fromMachineFile], ...Object.entries(dialectTitles)]),
      this.collisions(),
    ];
    this.fields = [...main, ...rare];
    const elements = (fields: Field[]) => fields.map((field) => field.element);
    const more = element("details", {}, element("summary", {}, words.more), element("div", {}, ...elements(rare)));
    this.element = element("div", { class: "variant-fields" }, ...elements(main), more);
  }

  show(variant: Variant): void {
    for (const field of this.fields) field.show(variant);
  }

  private name(): Field {
    const input = element("input", { type: "text", class: "text", spellcheck: "false", onchange: () => this.rename(input) });
    return { element: row(words.of.name, input), show: ({ name }) => showValue(input, name) };
  }

  /** Renames the variant; reverts an invalid name. */
  private rename(input: HTMLInputElement): void {
    if (!this.events.rename(input.value.trim())) input.value = input.dataset.displayed ?? "";
  }

  private choice(key: (typeof fileKeys)[number] | "controller" | "dialect", options: () => [string, string][]): Field {
    const label = words.of[key];
    const select = choice(label, [], "", (value) => {
      // A program sets its language, by its name.
      const setup = key === "program" ? { program: value, dialect: dialectOfName(value) } : { [key]: value };
      this.events.change(label, setup);
    });
    const show = ({ setup }: Variant) => {
      const all = options();
      if (!all.some(([value]) => value === setup[key])) all.push([setup[key], shortName(setup[key])]);
      setOptions(select, all, setup[key]);
    };
    return { element: row(label, select), show };
  }

  private file(key: (typeof fileKeys)[number]): Field {
    const none: [string, string][] = key === "program" ? [] : [["", key === "machine" ? words.builtInMachine : words.none]];
    return this.choice(key, () => [...none, ...namesOfKind(key, this.session.documents).map(fileOption)]);
  }

  private override(key: (typeof overrideKeys)[number]): Field {
    const label = words.of[key];
    const attributes = { type: "number", class: "number", min: 0, max: MAX_OVERRIDE_PERCENT, step: 5 };
    const input = element("input", {
      ...attributes,
      onchange: () => {
        const percent = Math.min(MAX_OVERRIDE_PERCENT, Math.max(0, Number(input.value) || 0));
        input.value = input.dataset.displayed = String(percent);
        this.events.change(label, { [key]: percent });
      },
    });
    return { element: row(label, input), show: ({ setup }) => showValue(input, String(setup[key])) };
  }

  private collisions(): Field {
    const { row: line, box } = check(words.of.collisions, (collisions) => this.events.change(words.of.collisions, { collisions }));
    return { element: line, show: ({ setup }) => (box.checked = setup.collisions) };
  }

  private from(): Field {
    const text = element("span", {});
    const button = element("button", { type: "button", onclick: () => this.events.fromStart() }, words.fromStart);
    const line = element("div", { class: "field" }, element("span", {}, words.fromRow), element("span", { class: "from" }, text, " ", button));
    const show = ({ from }: Variant) => {
      line.hidden = !from;
      text.textContent = from ? `${shortName(from.file)}, ${startText(from)}` : "";
    };
    return { element: line, show };
  }
}

const fileOption = (name: string): [string, string] => [name, shortName(name)];

// Keys that are too many to show all: words of programs, and the duration of each.

import { arrange, element } from "../../../core/dom";
import { texts } from "../../../texts";
import type { TomlTable } from "../file/toml";
import type { Context } from "./context";
import { Field, type FieldSpec } from "./field";
import type { TableLocation } from "./rows";

const words = texts.machine.words;

export class WordRows {
  readonly element: HTMLElement;
  private readonly list = element("div", {});
  private readonly fields = new Map<string, Field>();
  private readonly word = element("input", { type: "text", "aria-label": words.word, placeholder: words.word, spellcheck: "false" });
  private readonly error = element("p", { class: "key-fault", role: "alert" });

  /** `spec`: description of each value; `first`: value of a new word. */
  constructor(
    private readonly context: Context,
    private readonly spec: Omit<FieldSpec, "label">,
    private readonly first: string | number,
    private readonly home: () => TableLocation,
  ) {
    const add = element("button", { type: "button", onclick: () => void this.add() }, words.add);
    this.element = element("div", {}, this.list, element("div", { class: "buttons" }, this.word, add), this.error);
    this.word.addEventListener("keydown", (event) => {
      if (event.key === "Enter") void this.add();
    });
  }

  show(table: TomlTable): void {
    const names = Object.keys(table).sort();
    for (const name of [...this.fields.keys()]) if (!names.includes(name)) this.fields.delete(name);
    const all = names.map((name) => {
      const field = this.fields.get(name) ?? this.make(name);
      this.fields.set(name, field);
      field.show(table[name]);
      return field.element;
    });
    arrange(this.list, all);
  }

  private make(name: string): Field {
    return new Field(this.context.store, { ...this.spec, label: name }, (value) => {
      const { part, at, owner } = this.home();
      const place = [...at, name];
      return this.context.edits.change(part, texts.machine.changed(owner, name), [
        value === undefined ? { op: "remove", at: place } : { op: "set", at: place, value },
      ]);
    });
  }

  private async add(): Promise<void> {
    const name = this.word.value.trim();
    if (!name) return;
    const { part, at, owner } = this.home();
    const change = { op: "set" as const, at: [...at, name], value: this.first };
    this.error.textContent = await this.context.edits.change(part, texts.machine.changed(owner, name), [change]);
    if (this.error.textContent) return;
    this.word.value = "";
    this.fields.get(name)?.focus();
  }
}

// Controller: a built-in model or a file, and the keys that override it. A key is changed in the file that
// has it: the machine's, or that of the controller if the machine names one.

import { element } from "../../../core/dom";
import { baseName } from "../../../core/file_kinds";
import { controllerNames } from "../../../core/controller_override";
import { isTomlFile, referenceTo, resolved } from "../../../core/references";
import { texts } from "../../../texts";
import type { FileRole } from "../file/model";
import { tableAt, textAt, type TomlPath, type Toml } from "../file/toml";
import type { Context, Section } from "../form/context";
import { Field } from "../form/field";
import type { Key } from "../form/key_schema";
import { fieldSpec } from "../form/rows";

const words = texts.machine.controller;

interface Row {
  key: Key;
  at: TomlPath;
  field: Field;
}

class Controller implements Section {
  readonly element: HTMLElement;
  private readonly model: Field;
  private readonly rows: Row[];
  private readonly onlySetKeys: HTMLInputElement;

  constructor(
    private readonly context: Context,
    keys: (at: string) => Key[],
  ) {
    this.model = new Field(
      context.store,
      { label: words.model, kind: "choice", meaning: words.modelHint, showsMeaning: true },
      (value) => this.choose(value),
    );
    const ofItself = keys("controller").filter(({ name, kind }) => name !== "model" && kind !== "table");
    const main = ofItself.map((key) => this.makeRow(key, [key.name]));
    const tables = (["overrides", "stops"] as const).map((table) => ({
      title: words[table],
      rows: keys(`controller.${table}`).map((key) => this.makeRow(key, [table, key.name])),
    }));
    this.rows = [...main, ...tables.flatMap(({ rows }) => rows)];
    this.onlySetKeys = element("input", { type: "checkbox", onchange: () => this.filter() });
    const only = element("label", { class: "check" }, this.onlySetKeys, words.onlySetKeys);
    const list = (rows: Row[]) => element("div", { class: "rows" }, ...rows.map(({ field }) => field.element));
    const more = tables.map(({ title, rows }) => element("details", { class: "more-keys" }, element("summary", {}, title), list(rows)));
    this.element = element("div", {}, this.model.element, only, list(main), ...more);
  }

  private makeRow(key: Key, at: TomlPath): Row {
    // Words of programs are shown under their own names.
    const keyLabel = { label: key.name };
    const spec = fieldSpec(key, at[0] === "stops" ? keyLabel : { showsMeaning: true });
    return { key, at, field: new Field(this.context.store, spec, (value) => this.put(spec.label, at, value)) };
  }

  /** Returns the file that sets a key. */
  private findSetting(at: TomlPath): { part: FileRole; value: Toml | undefined } | null {
    for (const part of ["machine", "controller"] as const) {
      const table = tableAt(this.context.model.value(part), ["controller", ...at.slice(0, -1)]);
      const value = table[at[at.length - 1]];
      if (value !== undefined) return { part, value };
    }
    return null;
  }

  /** Returns the file for a key that no file sets. */
  private get defaultRole(): FileRole {
    return this.context.model.parts.has("controller") ? "controller" : "machine";
  }

  private put(label: string, at: TomlPath, value: Toml | undefined): Promise<string> {
    const { edits } = this.context;
    const home = this.findSetting(at);
    if (value === undefined && !home) return Promise.resolve("");
    const part = home?.part ?? this.defaultRole;
    const place = ["controller", ...at];
    return edits.change(part, texts.machine.changed(words.title, label), [
      value === undefined ? { op: "remove", at: place } : { op: "set", at: place, value },
    ]);
  }

  private choose(value: Toml | undefined): Promise<string> {
    const { model, edits } = this.context;
    const at = ["controller", "model"];
    if (value === undefined) return edits.change("machine", words.title, [{ op: "remove", at }]);
    const name = String(value);
    const reference = isTomlFile(name) ? referenceTo(model.file("machine"), name) : name;
    return edits.change("machine", texts.machine.changed(words.title, words.model), [{ op: "set", at, value: reference }]);
  }

  draw(): void {
    const { model } = this.context;
    const modelName = textAt(model.value("machine"), ["controller", "model"]);
    this.model.setOptions(this.models());
    this.model.show(isTomlFile(modelName) ? resolved(model.file("machine"), modelName) : modelName || undefined, "exact-stop");
    const file = model.parts.get("controller")?.file;
    for (const { key, at, field } of this.rows) {
      const fallback = tableAt(model.controllerBase, at.slice(0, -1))[at[at.length - 1]];
      const home = this.findSetting(at);
      field.show(home?.value, fallback ?? key.default);
      field.element.dataset.home = home?.part === "controller" && file ? words.inFile(baseName(file)) : "";
    }
    this.filter();
  }

  private filter(): void {
    for (const { at, field } of this.rows) field.element.hidden = this.onlySetKeys.checked && this.findSetting(at) === null;
  }

  /** Returns the built-in models by name, and the user's own files. */
  private models(): [string, string][] {
    const { documents } = this.context.session;
    return controllerNames(documents).map((name) => [name, baseName(name)]);
  }
}

export const createController = (context: Context, keys: (at: string) => Key[]): Section => new Controller(context, keys);


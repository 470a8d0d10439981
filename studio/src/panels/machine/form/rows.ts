// Keys of a table, each as a field.

import { element } from "../../../core/dom";
import { texts } from "../../../texts";
import type { FileRole } from "../file/model";
import type { TomlPath, Toml, TomlTable } from "../file/toml";
import type { Context } from "./context";
import { Field, type FieldSpec } from "./field";
import { nameIn, type Key } from "./key_schema";
import { keyLabel } from "./quantity";

const words = texts.machine;

/** A key's field. */
export function fieldSpec(key: Key, more: Partial<FieldSpec> = {}): FieldSpec {
  const { name, kind, elements, choices, open, required, ...range } = key;
  const textKind = choices && !open ? "choice" : "text";
  const kinds = { number: "number", text: textKind, switch: "switch", list: elements === "number" ? "numbers" : "list", table: "text" } as const;
  const listedOptions = choices?.map((choice) => [choice, choice] as const);
  return { ...range, label: keyLabel(name), kind: kinds[kind], choices: listedOptions, isRequired: required, ...more };
}

/** Returns the defaults of keys that are not set. */
export const keyDefaults = (keys: Key[]): TomlTable =>
  Object.fromEntries(keys.flatMap(({ name, default: value }) => (value === undefined ? [] : [[name, value]])));

/** Position of a table, and its name. */
export interface TableLocation {
  part: FileRole;
  at: TomlPath;
  /** "X": part of the machine that it describes; empty: the complete machine. */
  owner: string;
}

export class Rows {
  readonly element: HTMLElement;
  private readonly fields = new Map<string, Field>();
  private table: TomlTable = {};

  constructor(
    private readonly context: Context,
    private readonly specs: Record<string, FieldSpec>,
    private readonly home: () => TableLocation,
    name = "rows",
  ) {
    this.element = element("div", { class: name });
    for (const [key, spec] of Object.entries(specs)) {
      const field = new Field(context.store, spec, (value) => this.put(key, spec.label, value));
      this.fields.set(key, field);
      this.element.append(field.element);
    }
  }

  /** `fallbacks`: defaults of keys that the table does not have. */
  show(table: TomlTable, fallbacks: TomlTable = {}): void {
    this.table = table;
    for (const [key, field] of this.fields) field.show(table[this.nameInFile(key)], fallbacks[key]);
  }

  field(key: string): Field | undefined {
    return this.fields.get(key);
  }

  private nameInFile(key: string): string {
    return nameIn(this.table, key, this.specs[key]?.formerly);
  }

  private put(key: string, label: string, value: Toml | undefined): Promise<string> {
    const { part, at, owner } = this.home();
    const name = this.nameInFile(key);
    const place = [...at, name];
    if (value === undefined && this.table[name] === undefined) return Promise.resolve("");
    const change = value === undefined ? ({ op: "remove", at: place } as const) : ({ op: "set", at: place, value } as const);
    return this.context.edits.change(part, words.changed(owner, label), [change]);
  }
}

const POSE_KEYS = ["x_mm", "y_mm", "z_mm", "roll_deg", "pitch_deg", "yaw_deg"] as const;

/** Creates the six numbers of a frame. */
export function poseRows(context: Context, home: () => TableLocation): Rows {
  const spec = (key: string): FieldSpec => ({
    label: words.pose[key as (typeof POSE_KEYS)[number]],
    kind: "number",
    unit: key.endsWith("mm") ? "mm" : "deg",
    isNarrow: true,
  });
  return new Rows(context, Object.fromEntries(POSE_KEYS.map((key) => [key, spec(key)])), home, "rows pose");
}

export const ZERO_POSE: TomlTable = Object.fromEntries(POSE_KEYS.map((key) => [key, 0]));

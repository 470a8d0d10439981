// One object, frame or body: its shape, its parent, and its pose there.

import { element } from "../../../core/dom";
import { baseName } from "../../../core/file_kinds";
import { referenceTo, resolved } from "../../../core/references";
import { lengthNumber, lengthUnit } from "../../../core/units";
import { texts } from "../../../texts";
import type { FileRole } from "../file/model";
import { tableAt, tablesAt, textAt, type TomlPath, type Toml, type TomlChange, type TomlTable } from "../file/toml";
import type { Card } from "../form/cards";
import type { Context } from "../form/context";
import { Field } from "../form/field";
import { ZERO_POSE, Rows, poseRows, type TableLocation } from "../form/rows";
import type { ItemSelection } from "./item_selection";
import { isMesh, shapeKind, shapeDimensions, dimensionPath, shapeKinds, shapeSizes, convertShape, type ShapeKind } from "./shape";
import { attachKey, freeItemName, removeChanges, renameChanges, type ItemKind } from "./tree";

const words = texts.machine.items;

export interface ItemEvents {
  onRenamed(to: string): void;
  /** Returns the names of possible parents. */
  parents(index: number): string[];
  isTaken(name: string): boolean;
}

const MAX_LENGTH_MM = 1e6;

export class ItemCard implements Card {
  readonly element: HTMLDetailsElement;
  private index = 0;
  private readonly title = element("summary", {});
  private readonly name: Field;
  private readonly parentField: Field;
  private readonly role: Rows;
  private readonly pose: Rows;
  private readonly shape: Field;
  private readonly mesh: Field;
  private readonly meshRows: Rows;
  private readonly sizes: Record<string, Field[]>;

  constructor(
    private readonly context: Context,
    private readonly part: FileRole,
    private readonly kind: ItemKind,
    private readonly chosen: ItemSelection,
    private readonly events: ItemEvents,
  ) {
    const { store } = context;
    const home = (below: TomlPath = []) => (): TableLocation => ({ part, at: [...this.at, ...below], owner: this.called });
    this.name = new Field(store, { label: words.name, kind: "text", isRequired: true }, (value) => this.rename(String(value)));
    const attach = { label: kind === "shape" ? words.on : words.attachedTo, kind: "choice" as const, isRequired: kind === "shape" };
    this.parentField = new Field(store, attach, (value) => this.put(attach.label, attachKey(kind), value));
    const roles = (["fixture", "workpiece"] as const).map((each) => [each, words.roles[each]] as const);
    this.role = new Rows(context, kind === "object" ? { role: { label: words.role, kind: "choice", choices: roles, meaning: words.roleHint } } : {}, home());
    const kinds = shapeKinds.map((each) => [each, words.shapes[each]] as const);
    this.shape = new Field(store, { label: words.shape, kind: "choice", choices: kinds, isRequired: true }, (value) => this.changeShape(value as ShapeKind));
    this.mesh = new Field(store, { label: words.file, kind: "choice", isRequired: true }, (value) => this.setMesh(String(value)));
    this.meshRows = new Rows(context, { scale: { label: words.scale, kind: "number", above: 0, meaning: words.scaleHint } }, home(["shape"]));
    this.sizes = Object.fromEntries(shapeKinds.map((each) => [each, this.sizeFields(each)]));
    this.pose = poseRows(context, home(["frame"]));
    this.element = this.layOut();
    this.element.addEventListener("toggle", () => this.onToggle());
  }

  private sizeFields(kind: ShapeKind): Field[] {
    return shapeSizes(kind).parts.map((part, i) => {
      const label = words.sizes[part as keyof typeof words.sizes];
      const spec = { label, kind: "number" as const, unit: "mm", above: 0, max: MAX_LENGTH_MM, isRequired: true, isNarrow: true };
      return new Field(this.context.store, spec, (value) => this.edit(label, [{ op: "set", at: [...this.at, "shape", ...dimensionPath(kind, i)], value: value! }]));
    });
  }

  private layOut(): HTMLDetailsElement {
    const button = (text: string, act: () => void) => element("button", { type: "button", onclick: act }, text);
    const sizes = element("div", { class: "rows pose" }, ...Object.values(this.sizes).flatMap((fields) => fields.map((field) => field.element)));
    const body = this.kind === "frame" ? [] : [this.shape.element, sizes, this.mesh.element, this.meshRows.element];
    const buttons = element(
      "div",
      { class: "buttons" },
      button(words.duplicate, () => void this.duplicate()),
      button(words.remove, () => void this.remove()),
    );
    const parts = [this.name.element, ...body, this.role.element, this.parentField.element, this.pose.element, buttons];
    return element("details", { class: "card" }, this.title, ...parts);
  }

  private get at(): TomlPath {
    return [this.kind, this.index];
  }

  private get file(): TomlTable {
    return this.context.model.value(this.part);
  }

  private get table(): TomlTable {
    return tablesAt(this.file, [this.kind])[this.index] ?? {};
  }

  private get called(): string {
    return textAt(this.table, ["name"]);
  }

  draw(index: number): void {
    this.index = index;
    const { table } = this;
    const shape = tableAt(table, ["shape"]);
    const kind = shapeKind(shape);
    this.title.replaceChildren(element("b", {}, this.called || words.nameless), ` ${this.about(shape, kind)}`);
    this.name.show(table.name);
    this.role.show(table, { role: "fixture" });
    this.parentField.setOptions(this.events.parents(index).map((name) => [name, words.places[name as keyof typeof words.places] ?? name]));
    this.parentField.show(table[attachKey(this.kind)], this.kind === "shape" ? undefined : "world");
    this.pose.show(tableAt(table, ["frame"]), ZERO_POSE);
    if (this.kind !== "frame") this.drawShape(shape, kind);
    const isSelected = this.chosen.is(this.part, this.kind, this.called);
    if (this.element.open !== isSelected) this.open(isSelected);
  }

  /** Opens the card; one chosen elsewhere is scrolled into view. */
  private open(isOpen: boolean): void {
    this.element.open = isOpen;
    if (!isOpen) return;
    this.element.closest("details.section")?.setAttribute("open", "");
    this.element.scrollIntoView({ block: "nearest" });
  }

  private drawShape(shape: TomlTable, kind: ShapeKind | null): void {
    const { model, session } = this.context;
    this.shape.show(kind ?? undefined);
    const numbers = shapeDimensions(shape);
    for (const [each, fields] of Object.entries(this.sizes)) {
      fields.forEach((field, i) => {
        field.element.hidden = each !== kind;
        if (each === kind) field.show(numbers[i]);
      });
    }
    this.mesh.element.hidden = this.meshRows.element.hidden = kind !== "mesh";
    if (kind !== "mesh") return;
    const { documents } = session;
    const names = [...new Set([...documents.userFileNames(), ...documents.samples.keys()])].filter(isMesh);
    this.mesh.setOptions(names.map((name) => [name, baseName(name)]));
    this.mesh.show(resolved(model.file(this.part), textAt(shape, ["mesh"])));
    this.meshRows.show(shape, { scale: 1 });
  }

  private about(shape: TomlTable, kind: ShapeKind | null): string {
    if (this.kind === "frame") return "";
    if (kind === "mesh") return baseName(textAt(shape, ["mesh"]));
    const units = this.context.store.get("units");
    const numbers = shapeDimensions(shape).map((mm) => String(Number(lengthNumber(mm, units))));
    return kind ? `${words.shapes[kind]} ${numbers.join(" × ")} ${lengthUnit(units)}` : words.noShape;
  }

  private onToggle(): void {
    const isSelected = this.chosen.is(this.part, this.kind, this.called);
    if (this.element.open === isSelected) return;
    this.chosen.choose(this.element.open ? { part: this.part, kind: this.kind, name: this.called } : null);
  }

  private edit(what: string, changes: TomlChange[], made?: () => void): Promise<string> {
    return this.context.edits.change(this.part, texts.machine.changed(this.called, what), changes, made);
  }

  private put(label: string, key: string, value: Toml | undefined): Promise<string> {
    const at = [...this.at, key];
    if (value === undefined && this.table[key] === undefined) return Promise.resolve("");
    return this.edit(label, [value === undefined ? { op: "remove", at } : { op: "set", at, value }]);
  }

  private rename(to: string): Promise<string> {
    if (to === this.called) return Promise.resolve("");
    if (this.events.isTaken(to)) return Promise.resolve(words.taken(to));
    const from = this.called;
    return this.edit(words.name, renameChanges(this.file, this.at, from, to), () => {
      this.events.onRenamed(to);
      this.chosen.rename(this.part, this.kind, from, to);
    });
  }

  private changeShape(kind: ShapeKind): Promise<string> {
    const { documents } = this.context.session;
    const mesh = [...documents.userFileNames(), ...documents.samples.keys()].find(isMesh);
    if (kind === "mesh" && !mesh) return Promise.resolve(words.noMesh);
    const reference = mesh ? referenceTo(this.context.model.file(this.part), mesh) : "";
    const value = convertShape(kind, tableAt(this.table, ["shape"]), reference);
    return this.edit(words.shape, [{ op: "set", at: [...this.at, "shape"], value }]);
  }

  private setMesh(name: string): Promise<string> {
    const value = referenceTo(this.context.model.file(this.part), name);
    return this.edit(words.file, [{ op: "set", at: [...this.at, "shape", "mesh"], value }]);
  }

  private duplicate(): Promise<string> {
    const name = freeItemName(this.called, this.events.isTaken);
    const change = { op: "add" as const, at: [this.kind], value: { ...this.table, name } };
    return this.edit(words.duplicated, [change], () => this.chosen.choose({ part: this.part, kind: this.kind, name }));
  }

  private remove(): Promise<string> {
    return this.edit(words.removed, removeChanges(this.file, this.kind, this.index), () => this.chosen.choose(null));
  }
}

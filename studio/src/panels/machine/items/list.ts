// List of the objects, frames or bodies of a file.

import { element } from "../../../core/dom";
import { texts } from "../../../texts";
import type { FileRole } from "../file/model";
import { tablesAt, textAt, type Toml, type TomlTable } from "../file/toml";
import { CardList } from "../form/cards";
import type { Context, Section } from "../form/context";
import type { ItemSelection } from "./item_selection";
import { ItemCard } from "./item_card";
import { freeItemName, type ItemKind } from "./tree";

const words = texts.machine.items;

const tableNames = (value: TomlTable, kind: ItemKind): string[] => tablesAt(value, [kind]).map((table) => textAt(table, ["name"]));

/** Returns the names of objects and of machine parts that a file may use. */
export function bodyNames({ model }: Context, part: FileRole): string[] {
  const machineBodies = tableNames(model.value("machine"), "shape");
  const cell = model.value("cell");
  return part === "machine" ? machineBodies : [...tableNames(cell, "object"), ...tableNames(cell, "shape"), ...machineBodies];
}

/** Returns the names that are already used. */
const usedNames = (context: Context): string[] => [...tableNames(context.model.value("cell"), "frame"), ...bodyNames(context, "cell")];

/** Returns the parts of the machine that can be parents. */
function machineParents({ model }: Context): string[] {
  const letters = tablesAt(model.value("machine"), ["axis"]).map((axis) => textAt(axis, ["letter"]));
  return ["base", ...letters, "tool", "work"];
}

function possibleParents(context: Context, kind: ItemKind, index: number): string[] {
  const machineBodies = machineParents(context);
  if (kind === "shape") return [...machineBodies, "jet"];
  const cell = context.model.value("cell");
  const frames = tableNames(cell, "frame");
  const above = kind === "frame" ? frames.slice(0, index) : [...frames, ...tableNames(cell, "object").slice(0, index)];
  const conveyors = tablesAt(context.model.value("robots"), ["conveyor"]).map((table) => textAt(table, ["name"]));
  return ["world", ...above, ...conveyors, ...machineBodies, ...tableNames(context.model.value("machine"), "shape")];
}

/** Name and contents of a new item. */
interface NewItemOption {
  label: string;
  name: string;
  table: Record<string, Toml>;
}

export function newItemOptions(kind: ItemKind): NewItemOption[] {
  if (kind === "frame") return [{ label: words.addFrame, name: words.newFrame, table: {} }];
  const on: Record<string, Toml> = kind === "shape" ? { on: "tool" } : {};
  const offer = (shape: "box" | "cylinder" | "sphere", form: Record<string, Toml>): NewItemOption => ({
    label: words.add(words.shapes[shape]),
    name: words.shapes[shape],
    table: { ...on, shape: form },
  });
  return [
    offer("box", { box_mm: [100, 100, 100] }),
    offer("cylinder", { cylinder_mm: [100, 100] }),
    offer("sphere", { sphere_mm: 100 }),
  ];
}

export function createItemList(context: Context, part: FileRole, kind: ItemKind, chosen: ItemSelection): Section & { add(offer: NewItemOption): Promise<string> } {
  const host = element("div", { class: "cards" });
  const isTaken = (name: string) => usedNames(context).includes(name);
  const cards: CardList = new CardList(host, (name) => {
    let known = name;
    const onRenamed = (to: string) => {
      cards.rename(known, to);
      known = to;
    };
    return new ItemCard(context, part, kind, chosen, { onRenamed, parents: (index) => possibleParents(context, kind, index), isTaken });
  });
  const add = ({ name: requested, table }: NewItemOption) => {
    const name = freeItemName(requested, isTaken);
    const change = { op: "add" as const, at: [kind], value: { name, ...table } };
    return context.edits.change(part, texts.machine.changed(name, words.added), [change], () => chosen.choose({ part, kind, name }));
  };
  const buttons = newItemOptions(kind).map((offer) => element("button", { type: "button", onclick: () => void add(offer) }, offer.label));
  const draw = () => cards.draw(tableNames(context.model.value(part), kind).map((name, i) => name || String(i + 1)));
  chosen.on(draw);
  return { element: element("div", {}, host, element("div", { class: "buttons" }, ...buttons)), draw, add };
}


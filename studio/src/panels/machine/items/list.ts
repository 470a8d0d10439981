// List of the objects, frames or bodies of a file.

import { element } from "../../../core/dom";
import { texts } from "../../../texts";
import type { Part } from "../file/model";
import { tablesAt, textAt, type Toml, type TomlTable } from "../file/toml";
import { Cards } from "../form/cards";
import type { Context, Section } from "../form/context";
import type { Chosen } from "./chosen";
import { ItemCard } from "./item_card";
import { freeNameOf, type ItemKind } from "./tree";

const words = texts.machine.items;

const namesOf = (value: TomlTable, kind: ItemKind): string[] => tablesAt(value, [kind]).map((table) => textAt(table, ["name"]));

/** Returns the names of objects and of machine parts that a file may use. */
export function bodyNames({ model }: Context, part: Part): string[] {
  const ofMachine = namesOf(model.value("machine"), "shape");
  const cell = model.value("cell");
  return part === "machine" ? ofMachine : [...namesOf(cell, "object"), ...namesOf(cell, "shape"), ...ofMachine];
}

/** Returns the names that are already used. */
const takenNames = (context: Context): string[] => [...namesOf(context.model.value("cell"), "frame"), ...bodyNames(context, "cell")];

/** Returns the parts of the machine that can be parents. */
function placesOfMachine({ model }: Context): string[] {
  const letters = tablesAt(model.value("machine"), ["axis"]).map((axis) => textAt(axis, ["letter"]));
  return ["base", ...letters, "tool", "work"];
}

function parentsOf(context: Context, kind: ItemKind, index: number): string[] {
  const ofMachine = placesOfMachine(context);
  if (kind === "shape") return [...ofMachine, "jet"];
  const cell = context.model.value("cell");
  const frames = namesOf(cell, "frame");
  const above = kind === "frame" ? frames.slice(0, index) : [...frames, ...namesOf(cell, "object").slice(0, index)];
  const conveyors = tablesAt(context.model.value("robots"), ["conveyor"]).map((table) => textAt(table, ["name"]));
  return ["world", ...above, ...conveyors, ...ofMachine, ...namesOf(context.model.value("machine"), "shape")];
}

/** Name and contents of a new item. */
interface Offer {
  label: string;
  name: string;
  table: Record<string, Toml>;
}

export function offersOf(kind: ItemKind): Offer[] {
  if (kind === "frame") return [{ label: words.addFrame, name: words.newFrame, table: {} }];
  const on: Record<string, Toml> = kind === "shape" ? { on: "tool" } : {};
  const offer = (shape: "box" | "cylinder" | "sphere", form: Record<string, Toml>): Offer => ({
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

export function createItems(context: Context, part: Part, kind: ItemKind, chosen: Chosen): Section & { add(offer: Offer): Promise<string> } {
  const host = element("div", { class: "cards" });
  const isTaken = (name: string) => takenNames(context).includes(name);
  const cards: Cards = new Cards(host, (name) => {
    let known = name;
    const renamed = (to: string) => {
      cards.rename(known, to);
      known = to;
    };
    return new ItemCard(context, part, kind, chosen, { renamed, parents: (index) => parentsOf(context, kind, index), isTaken });
  });
  const add = ({ name: wanted, table }: Offer) => {
    const name = freeNameOf(wanted, isTaken);
    const change = { op: "add" as const, at: [kind], value: { name, ...table } };
    return context.edits.change(part, texts.machine.changed(name, words.added), [change], () => chosen.choose({ part, kind, name }));
  };
  const buttons = offersOf(kind).map((offer) => element("button", { type: "button", onclick: () => void add(offer) }, offer.label));
  const draw = () => cards.draw(namesOf(context.model.value(part), kind).map((name, i) => name || String(i + 1)));
  chosen.on(draw);
  return { element: element("div", {}, host, element("div", { class: "buttons" }, ...buttons)), draw, add };
}


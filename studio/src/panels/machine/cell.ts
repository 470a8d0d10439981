// Form of the cell's file: the bodies around the machine.

import { arrange, element } from "../../core/dom";
import { baseName, kindOfFile, namesOfKind, shortName, type FileKind } from "../../core/file_kinds";
import { referenceTo, resolved } from "../../core/references";
import { texts } from "../../texts";
import { FileRow } from "./file_row";
import { freeName } from "./file/file_names";
import { tableAt, tablesAt, textAt, type TomlTable } from "./file/toml";
import type { Context, Section } from "./form/context";
import { Field } from "./form/field";
import { Rows } from "./form/rows";
import type { ItemSelection } from "./items/item_selection";
import { createDistance } from "./items/distance";
import { createItemList } from "./items/list";
import { createPairs } from "./items/pairs";
import { isMesh } from "./items/shape";
import type { FileForm } from "./machine";

const words = texts.machine.cell;

/** Creates the section for the table [cell]: its name, and the files that belong to it. */
function createCellSection(context: Context): Section {
  const { edits, model, session, store } = context;
  const home = () => ({ part: "cell" as const, at: ["cell"], owner: words.title });
  const rows = new Rows(
    context,
    {
      name: { label: words.name, kind: "text", isRequired: true },
      clearance_mm: { label: words.clearance, kind: "number", unit: "mm", min: 0, meaning: words.clearanceHint, showsMeaning: true },
    },
    home,
  );
  const fileField = (key: "machine" | "machine_data", label: string) => {
    const put = (name: string | undefined) => {
      const at = ["cell", key];
      const change = name ? ({ op: "set", at, value: referenceTo(model.file("cell"), name) } as const) : ({ op: "remove", at } as const);
      return edits.change("cell", texts.machine.changed(words.title, label), [change]);
    };
    return new Field(store, { label, kind: "choice", meaning: words.fileHint[key] }, (value) => put(value as string | undefined));
  };
  const files = { machine: fileField("machine", words.machine), machine_data: fileField("machine_data", words.machineData) };
  const draw = () => {
    const head = tableAt(model.value("cell"), ["cell"]);
    rows.show(head, { clearance_mm: 0 });
    for (const [key, field] of Object.entries(files)) {
      const reference = textAt(head, [key]);
      field.setOptions(namesOfKind(key as FileKind, session.documents).map((name) => [name, shortName(name)]));
      field.show(reference ? resolved(model.file("cell"), reference) : undefined);
    }
  };
  return { element: element("div", {}, rows.element, files.machine.element, files.machine_data.element), draw };
}

/** Returns the names of the meshes that the cell has. */
const meshNames = (cell: TomlTable, file: string): string[] =>
  ["object", "shape"].flatMap((kind) => tablesAt(cell, [kind]).map((table) => textAt(table, ["shape", "mesh"]))).filter((name) => name !== "").map((name) => resolved(file, name));

/** Creates the section of dropped meshes that are not used yet: a click makes one an object. */
function createMeshes(context: Context, add: (name: string, file: string) => void): Section {
  const { model, session } = context;
  const host = element("div", { class: "meshes" });
  const buttons = new Map<string, HTMLElement>();
  const meshButton = (file: string) => {
    const known = buttons.get(file) ?? element("button", { type: "button", onclick: () => add(baseName(file).replace(/\.\w+$/, ""), file) }, words.addMesh(baseName(file)));
    buttons.set(file, known);
    return known;
  };
  return {
    element: host,
    draw() {
      const used = meshNames(model.value("cell"), model.file("cell"));
      arrange(host, session.documents.userFileNames().filter((name) => isMesh(name) && !used.includes(name)).map(meshButton));
    },
  };
}

const section = (title: string, open: boolean, ...parts: Section[]): Section => ({
  element: element("details", { class: "section", open }, element("summary", {}, title), ...parts.map((part) => part.element)),
  draw: () => parts.forEach((part) => part.draw()),
});

/** Creates a cell that contains only the current machine. */
function newCell(context: Context): void {
  const { edits, model, session } = context;
  const name = freeName("my-cell.toml", (each) => session.documents.exists(each));
  const machine = model.file("machine");
  const isMachine = kindOfFile(machine, session.documents.get(machine) ?? "") === "machine";
  const text = `[cell]\nname = ${JSON.stringify(words.newName)}\n${isMachine ? `machine = ${JSON.stringify(referenceTo(name, machine))}\n` : ""}`;
  void edits.choose("cell", words.made, name, text);
}

export function createCell(context: Context, chosen: ItemSelection): FileForm {
  const { model } = context;
  const row = new FileRow(context, "cell");
  const objects = createItemList(context, "cell", "object", chosen);
  const meshes = createMeshes(context, (name, file) => {
    void objects.add({ label: "", name, table: { shape: { mesh: referenceTo(model.file("cell"), file) } } });
  });
  const sections = [
    section(words.objects, true, objects, meshes),
    section(words.head, false, createCellSection(context)),
    section(words.frames, false, createItemList(context, "cell", "frame", chosen)),
    section(words.parts, false, createItemList(context, "cell", "shape", chosen)),
    section(texts.machine.pairs.title, false, createPairs(context, "cell")),
    section(words.distance, false, createDistance(context)),
  ];
  const host = element("div", { class: "sections" }, ...sections.map((each) => each.element));
  const none = element(
    "div",
    { class: "no-cell" },
    element("p", {}, words.none),
    element("button", { type: "button", class: "primary", onclick: () => newCell(context) }, words.make),
  );
  return {
    element: element("div", {}, none, row.element, host),
    draw() {
      const cell = model.parts.get("cell");
      none.hidden = cell !== undefined;
      row.element.hidden = cell === undefined;
      host.hidden = !cell?.value;
      if (!cell) return;
      row.draw();
      if (cell.value) for (const each of sections) each.draw();
    },
    setDiagnostics: (errors) => row.setDiagnostics(errors),
  };
}

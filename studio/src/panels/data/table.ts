// Entries of a section: a row for each. Arrows move between rows, Enter changes and Delete resets.

import { arrange, element } from "../../core/dom";
import { texts } from "../../texts";
import { makeRows } from "../results/rows";
import { lengthUnit, type Entry, type Field, type Section, type Value } from "./data_request";

const words = texts.data;

export interface TableEvents {
  edit(): void;
  reset(): void;
  /** Another row is chosen. */
  chosen(): void;
  /** Called when the row with the focus was removed and no other row is left. */
  onEmptied(): void;
  /** Called to switch the lengths of an entry to the other unit. */
  unit(entry: Entry): void;
}

interface Row {
  element: HTMLTableRowElement;
  unit: HTMLButtonElement;
  entry: Entry;
}

const valueText = (value: Value): string => (value === null ? words.noWall : String(value ?? ""));

/** Returns the required fields, and those that have a value. */
const visibleFields = ({ fields }: Section, entries: Entry[]): Field[] =>
  fields.filter(({ name, required }) => required || entries.some((entry) => entry[name] !== undefined));

const heading = ({ name, unit }: Field): string => (unit === "angle" ? `${name}, ${words.angle}` : name);

export class EntryTable {
  private readonly caption = element("caption", { class: "unseen" });
  private readonly head = element("tr", {});
  private readonly body = element("tbody", {});
  private readonly table = element("table", { class: "entries" }, this.caption, element("thead", {}, this.head), this.body);
  private readonly note = element("p", { class: "note" });
  readonly element = element("div", { class: "wide" }, this.table, this.note);
  private rows = new Map<string, Row>();
  private section = "";
  private chosenId = "";

  constructor(private readonly events: TableEvents) {
    makeRows(this.body, () => {}, { Enter: () => events.edit(), Delete: () => events.reset() });
    this.body.addEventListener("focusin", (event) => {
      const row = [...this.rows.values()].find((each) => each.element.contains(event.target as Node));
      if (row) this.choose(row.entry.id);
    });
    this.body.addEventListener("dblclick", (event) => {
      if (!(event.target as Element).closest("button")) events.edit();
    });
  }

  /** Undefined: there are no entries. */
  get chosen(): Entry | undefined {
    return this.rows.get(this.chosenId)?.entry;
  }

  /** Selects the entry with that id as soon as it exists. */
  choose(id: string): void {
    this.chosenId = id;
    this.mark();
    this.events.chosen();
  }

  /** Keeps the rows of entries that remain, with the focus. */
  show(section: Section, entries: Entry[]): void {
    if (section.name !== this.section) this.rows = new Map();
    this.section = section.name;
    const fields = visibleFields(section, entries);
    this.caption.textContent = words.table(section.title);
    this.note.textContent = section.has_unit ? words.empty : words.noEntries;
    this.note.hidden = entries.length > 0;
    this.table.hidden = entries.length === 0;
    const headings = [words.id, ...fields.map(heading), ...(section.has_unit ? [words.unit] : [])];
    const hints = ["", ...fields.map(({ meaning }) => meaning), ""];
    this.head.replaceChildren(...headings.map((text, i) => element("th", { scope: "col", title: hints[i] || false }, text)));

    const ids = [...this.rows.keys()];
    const focusedRow = ids.findIndex((id) => this.rows.get(id)!.element.contains(document.activeElement));
    const selectedRow = ids.indexOf(this.chosenId);
    const before = this.rows;
    this.rows = new Map(entries.map((entry) => [entry.id, before.get(entry.id) ?? this.createRow(entry)]));
    for (const entry of entries) this.fill(this.rows.get(entry.id)!, entry, fields);
    arrange(this.body, [...this.rows.values()].map((row) => row.element));
    // If the chosen row has been removed, the next one is chosen. It gets the focus if the old one had it.
    const all = [...this.rows.keys()];
    const isRemoved = !this.rows.has(this.chosenId);
    if (isRemoved) this.chosenId = all[Math.min(Math.max(selectedRow, 0), all.length - 1)] ?? "";
    this.mark();
    this.events.chosen();
    if (!isRemoved || focusedRow < 0) return;
    if (this.chosenId) this.rows.get(this.chosenId)!.element.focus();
    else this.events.onEmptied();
  }

  private createRow(entry: Entry): Row {
    const row: Row = {
      element: element("tr", { tabindex: -1 }),
      // The table is one stop of the Tab key; by keyboard the unit is set in the form of the entry.
      unit: element("button", { tabindex: -1, onclick: () => this.events.unit(row.entry) }),
      entry,
    };
    return row;
  }

  private fill(row: Row, entry: Entry, fields: Field[]): void {
    row.entry = entry;
    const cells: HTMLElement[] = [
      element("th", { scope: "row" }, entry.id),
      ...fields.map(({ name }) => element("td", {}, valueText(entry[name]))),
    ];
    if (entry.unit) {
      row.unit.textContent = words.units[entry.unit];
      row.unit.title = words.unitHint(entry.id, lengthUnit(entry.unit === "inch" ? "metric" : "inch"));
      cells.push(row.unit.parentElement ?? element("td", {}, row.unit));
    }
    arrange(row.element, cells);
  }

  private mark(): void {
    for (const [id, row] of this.rows) {
      row.element.setAttribute("aria-selected", String(id === this.chosenId));
      row.element.tabIndex = id === this.chosenId ? 0 : -1;
    }
  }
}

// Axes, each as a card: its capabilities are visible, its geometry is under "More".

import { element } from "../../../core/dom";
import { texts } from "../../../texts";
import { tableAt, tablesAt, textAt, type TomlChange, type TomlTable } from "../file/toml";
import { CardList, type Card } from "../form/cards";
import type { Context, Section } from "../form/context";
import { Field, type FieldSpec } from "../form/field";
import type { Key } from "../form/key_schema";
import { numberText, unitText } from "../form/quantity";
import { ZERO_POSE, Rows, keyDefaults, poseRows, fieldSpec } from "../form/rows";

const words = texts.machine.axes;
const AXIS_LETTERS = [..."XYZABCUVW"];

type Kind = "linear" | "rotary";
const kindOf = (axis: TomlTable): Kind => (axis.kind === "rotary" ? "rotary" : "linear");

/** Returns the visible keys; the others are under "More". */
const mainKeys = (kind: Kind): string[] =>
  kind === "linear"
    ? ["min_mm", "max_mm", "max_speed_mm_s", "max_acceleration_mm_s2", "max_jerk_mm_s3", "home_mm"]
    : ["min_deg", "max_deg", "max_speed_deg_s", "max_acceleration_deg_s2", "max_jerk_deg_s3", "home_deg"];

const basicKeys = ["letter", "kind", "direction", "frame", "dh"];
const DH = ["theta_deg", "d_mm", "a_mm", "alpha_deg"];

class AxisCard implements Card {
  readonly element: HTMLDetailsElement;
  private index = 0;
  private readonly title = element("summary", {});
  private readonly letter: Field;
  private readonly kind: Field;
  private readonly direction: Rows;
  private readonly frame: Rows;
  private readonly dh: Rows;
  private readonly rowsByKind: Record<Kind, { main: Rows; more: Rows }>;

  constructor(
    private readonly context: Context,
    private readonly keys: Record<Kind, Key[]>,
    private readonly onRenamed: (to: string) => void,
  ) {
    const home = () => ({ part: "machine" as const, at: ["axis", this.index], owner: this.name });
    const below = (key: string) => () => ({ ...home(), at: ["axis", this.index, key] });
    const letters = AXIS_LETTERS.map((each) => [each, each] as const);
    const kinds = (["linear", "rotary"] as const).map((each) => [each, words[each]] as const);
    this.letter = new Field(context.store, { label: words.letter, kind: "choice", choices: letters, isRequired: true }, (value) => this.rename(String(value)));
    this.kind = new Field(context.store, { label: words.kind, kind: "choice", choices: kinds, isRequired: true, meaning: words.kindHint }, (value) => this.changeKind(String(value)));
    const rowsByKind = (kind: Kind) => {
      const all = keys[kind].filter(({ name }) => !basicKeys.includes(name));
      const main = mainKeys(kind);
      const rows = (isMain: boolean) =>
        new Rows(context, Object.fromEntries(all.filter(({ name }) => main.includes(name) === isMain).map((key) => [key.name, fieldSpec(key)])), home);
      return { main: rows(true), more: rows(false) };
    };
    this.rowsByKind = { linear: rowsByKind("linear"), rotary: rowsByKind("rotary") };
    const direction = keys.linear.find(({ name }) => name === "direction");
    this.direction = new Rows(context, direction ? { direction: fieldSpec(direction) } : {}, home);
    this.frame = poseRows(context, below("frame"));
    const dh = (key: string): FieldSpec => ({ label: words.dh[key as keyof typeof words.dh], kind: "number", unit: key.endsWith("mm") ? "mm" : "deg", isNarrow: true });
    this.dh = new Rows(context, Object.fromEntries(DH.map((key) => [key, dh(key)])), below("dh"), "rows pose");
    this.element = this.layOut();
  }

  private layOut(): HTMLDetailsElement {
    const { linear, rotary } = this.rowsByKind;
    const button = (text: string, act: () => void) => element("button", { type: "button", onclick: act }, text);
    const more = element(
      "details",
      { class: "more-keys" },
      element("summary", {}, words.more),
      this.kind.element,
      linear.more.element,
      rotary.more.element,
      this.direction.element,
      element("h4", {}, words.frame),
      this.frame.element,
      this.dh.element,
    );
    const buttons = element(
      "div",
      { class: "buttons" },
      button(words.up, () => void this.move(-1)),
      button(words.down, () => void this.move(1)),
      button(words.remove, () => void this.remove()),
    );
    return element("details", { class: "card" }, this.title, this.letter.element, linear.main.element, rotary.main.element, more, buttons);
  }

  private get axis(): TomlTable {
    return tablesAt(this.context.model.value("machine"), ["axis"])[this.index] ?? {};
  }

  private get name(): string {
    return textAt(this.axis, ["letter"]) || String(this.index + 1);
  }

  draw(index: number): void {
    this.index = index;
    const { axis } = this;
    const kind = kindOf(axis);
    this.title.replaceChildren(element("b", {}, this.name), ` ${this.about(axis, kind)}`);
    this.letter.show(axis.letter);
    this.kind.show(axis.kind);
    for (const [each, { main, more }] of Object.entries(this.rowsByKind)) {
      main.element.hidden = more.element.hidden = each !== kind;
      if (each === kind) for (const rows of [main, more]) rows.show(axis, keyDefaults(this.keys[kind]));
    }
    const hasDh = axis.dh !== undefined;
    this.direction.element.hidden = this.frame.element.hidden = hasDh;
    this.dh.element.hidden = !hasDh;
    this.direction.show(axis);
    this.frame.show(tableAt(axis, ["frame"]), ZERO_POSE);
    this.dh.show(tableAt(axis, ["dh"]), { theta_deg: 0, d_mm: 0, a_mm: 0, alpha_deg: 0 });
  }

  private about(axis: TomlTable, kind: Kind): string {
    const unit = kind === "linear" ? "mm" : "deg";
    const units = this.context.store.get("units");
    const [least, most] = [axis[`min_${unit}`], axis[`max_${unit}`]].map((limit) => numberText(limit, unit, units));
    const range = least || most ? words.range(least || "−∞", most || "∞", unitText(unit, units)) : words.endless;
    return `${words[kind]}, ${range}`;
  }

  private edit(what: string, changes: TomlChange[], made?: () => void): Promise<string> {
    return this.context.edits.change("machine", texts.machine.changed(this.name, what), changes, made);
  }

  private rename(letter: string): Promise<string> {
    const change = { op: "set" as const, at: ["axis", this.index, "letter"], value: letter };
    return this.edit(words.letter, [change], () => this.onRenamed(letter));
  }

  /** Changes the kind; values in mm mean nothing in degrees, and are removed. */
  private changeKind(kind: string): Promise<string> {
    const known = this.keys[kind as Kind].map(({ name }) => name);
    const gone = Object.keys(this.axis).filter((key) => !known.includes(key));
    return this.edit(words.kind, [
      ...gone.map((key) => ({ op: "remove" as const, at: ["axis", this.index, key] })),
      { op: "set", at: ["axis", this.index, "kind"], value: kind },
    ]);
  }

  private move(by: number): Promise<string> {
    const count = tablesAt(this.context.model.value("machine"), ["axis"]).length;
    const to = this.index + by;
    if (to < 0 || to >= count) return Promise.resolve("");
    return this.edit(words.moved, [{ op: "move", at: ["axis", this.index], to }]);
  }

  private remove(): Promise<string> {
    return this.edit(words.removed, [{ op: "remove", at: ["axis", this.index] }]);
  }
}

export function createAxes(context: Context, keys: Record<Kind, Key[]>): Section {
  const host = element("div", { class: "cards" });
  const cards: CardList = new CardList(host, (name) => {
    let known = name;
    return new AxisCard(context, keys, (to) => {
      cards.rename(known, to);
      known = to;
    });
  });
  const axes = () => tablesAt(context.model.value("machine"), ["axis"]);
  const add = (kind: Kind) => {
    const letter = AXIS_LETTERS.find((each) => !axes().some((axis) => axis.letter === each));
    if (!letter) return;
    const value = { letter, kind, direction: "z" };
    void context.edits.change("machine", texts.machine.changed(letter, words.added), [{ op: "add", at: ["axis"], value }]);
  };
  const buttons = (["linear", "rotary"] as const).map((kind) =>
    element("button", { type: "button", onclick: () => add(kind) }, words.add[kind]),
  );
  return {
    element: element("div", {}, host, element("div", { class: "buttons" }, ...buttons)),
    draw: () => cards.draw(axes().map((axis, i) => textAt(axis, ["letter"]) || String(i + 1))),
  };
}

// Leads: their kind, size and side, and whether they are in, out or both.

import { check, element } from "../../core/dom";
import type { Units } from "../../core/store";
import type { LeadChoice } from "../../run/path/leads";
import { texts } from "../../texts";
import { ChoiceRow, NumberRow } from "./fields";

const words = texts.paths.leads;
const first: LeadChoice = { kind: "arc", size_mm: 3, angle_deg: 90, side: "right", into: true, out: true };

export class LeadsForm {
  readonly element: HTMLDetailsElement;
  private choice = first;
  private units: Units = "mm";
  private readonly kind = new ChoiceRow<LeadChoice["kind"]>(words.kind, [["arc", words.arc], ["line", words.line]], (kind) => this.set({ kind }));
  private readonly size = new NumberRow(words.size, "length", (size_mm) => this.set({ size_mm: size_mm ?? first.size_mm }));
  private readonly angle = new NumberRow(words.angle, "angle", (angle_deg) => this.set({ angle_deg: angle_deg ?? first.angle_deg }));
  private readonly side = new ChoiceRow<LeadChoice["side"]>(
    words.side,
    [["right", words.right], ["left", words.left]],
    (side) => this.set({ side }),
  );
  private readonly into = check(words.into, (into) => this.set({ into }));
  private readonly out = check(words.out, (out) => this.set({ out }));
  private readonly button = element("button", { type: "button", onclick: () => this.add(this.choice) }, words.add);

  constructor(private readonly add: (choice: LeadChoice) => void) {
    this.element = element(
      "details",
      { class: "leads" },
      element("summary", {}, words.title),
      this.kind.element,
      this.size.element,
      this.angle.element,
      this.side.element,
      element("div", { class: "checks" }, this.into.row, this.out.row),
      this.button,
      element("p", { class: "note" }, words.hint),
    );
    this.set({});
  }

  private set(change: Partial<LeadChoice>): void {
    this.choice = { ...this.choice, ...change };
    this.show(this.units);
  }

  show(units: Units): void {
    const { kind, size_mm, angle_deg, side, into, out } = this.choice;
    this.units = units;
    this.kind.show(kind);
    this.size.show({ value: size_mm }, units);
    this.angle.show({ value: angle_deg }, units);
    this.angle.element.hidden = kind === "arc";
    this.side.show(side);
    this.into.box.checked = into;
    this.out.box.checked = out;
    this.button.disabled = !(size_mm > 0) || !(angle_deg >= 0 && angle_deg <= 90) || !(into || out);
  }
}

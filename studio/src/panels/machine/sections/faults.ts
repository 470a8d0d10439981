// Errors of the files: position, message, and a link to the text.

import { arrange, element } from "../../../core/dom";
import { baseName } from "../../../core/kinds";
import { texts } from "../../../texts";
import type { Told } from "../../../run/run";

const words = texts.machine.faults;

const placeOf = ({ file, line, column }: Told): string =>
  [baseName(file), ...(line > 0 ? [line, column] : [])].filter((part) => part !== "").join(":");

export class Faults {
  readonly element = element("ul", { class: "faults", role: "alert", "aria-label": words.title, hidden: true });
  private shown = "";

  /** `go`: opens the text of a file at a line; null: no link. */
  constructor(private readonly go: ((file: string, line: number) => void) | null) {}

  show(faults: readonly Told[]): void {
    const texts = faults.map((fault) => `${placeOf(fault)} ${fault.text}`);
    // Unchanged messages are not announced again, and keep the focus.
    if (texts.join("\n") === this.shown) return;
    this.shown = texts.join("\n");
    this.element.hidden = faults.length === 0;
    arrange(this.element, faults.map((fault) => this.rowOf(fault)));
  }

  private rowOf(fault: Told): HTMLElement {
    const { file, line, severity, text, hint } = fault;
    const sentence = element("span", {}, hint ? `${text} (${hint})` : text);
    const { go } = this;
    const place = placeOf(fault);
    const way = go && file ? element("button", { type: "button", title: words.go, onclick: () => go(file, Math.max(line, 1)) }, place) : place;
    return element("li", { class: severity }, way, " ", sentence);
  }
}

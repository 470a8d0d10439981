// Errors of the files: position, message, and a link to the text.

import { arrange, element } from "../../../core/dom";
import { baseName } from "../../../core/file_kinds";
import { texts } from "../../../texts";
import type { EngineDiagnostic } from "../../../run/run";

const words = texts.machine.errors;

const locationText = ({ file, line, column }: EngineDiagnostic): string =>
  [baseName(file), ...(line > 0 ? [line, column] : [])].filter((part) => part !== "").join(":");

export class ErrorList {
  readonly element = element("ul", { class: "faults", role: "alert", "aria-label": words.title, hidden: true });
  private displayed = "";

  /** `go`: opens the text of a file at a line; null: no link. */
  constructor(private readonly go: ((file: string, line: number) => void) | null) {}

  show(errors: readonly EngineDiagnostic[]): void {
    const texts = errors.map((error) => `${locationText(error)} ${error.text}`);
    // Unchanged messages are not announced again, and keep the focus.
    if (texts.join("\n") === this.displayed) return;
    this.displayed = texts.join("\n");
    this.element.hidden = errors.length === 0;
    arrange(this.element, errors.map((error) => this.createRow(error)));
  }

  private createRow(error: EngineDiagnostic): HTMLElement {
    const { file, line, severity, text, hint } = error;
    const sentence = element("span", {}, hint ? `${text} (${hint})` : text);
    const { go } = this;
    const place = locationText(error);
    const way = go && file ? element("button", { type: "button", title: words.go, onclick: () => go(file, Math.max(line, 1)) }, place) : place;
    return element("li", { class: severity }, way, " ", sentence);
  }
}

// Warnings about machine data, and errors of their file.

import { element } from "../../core/dom";
import type { EngineDiagnostic } from "../../run/run";
import { texts } from "../../texts";

export interface Problems {
  element: HTMLElement;
  /** `error`: why the data are missing; empty: they exist. */
  show(diagnostics: EngineDiagnostic[], error: string): void;
}

export function createProblems(): Problems {
  const sentence = element("p", { class: "sentence error" });
  const list = element("ul", { class: "rows" });
  const host = element("div", { class: "problems", role: "status" }, sentence, list);
  return {
    element: host,
    show(diagnostics, error) {
      sentence.textContent = error;
      sentence.hidden = !error;
      list.replaceChildren(...diagnostics.map(problem));
    },
  };
}

function problem({ severity, line, text, hint }: EngineDiagnostic): HTMLElement {
  const place = line > 0 ? [element("span", { class: "mark-place" }, texts.run.line(line))] : [];
  const said = element("span", { class: "mark-text" }, text);
  return element("li", { class: `mark ${severity}`, title: hint || false }, ...place, said);
}

// Status below the editor: findings, cursor position, and dialect.

import { nextDiagnostic } from "@codemirror/lint";
import type { EditorView } from "@codemirror/view";
import { element } from "../core/dom";
import { texts } from "../texts";
import type { Problems } from "./text_checker";

const words = texts.code;

export class Status {
  readonly dom: HTMLElement;
  private readonly problems = element("button", { class: "code-problems", type: "button", title: words.problemsTitle });
  private readonly place = element("span", { class: "code-place" });
  private readonly times = element("span", { class: "code-dim", title: words.noTimesTitle, hidden: true }, words.noTimes);
  private readonly dialect = element("span", { class: "code-dim" });
  private readonly readAs = element("button", { type: "button", title: words.readAsTitle });

  /** `readAs`: called if the user wants the program read in the offered dialect. */
  constructor(view: () => EditorView, readAs: () => void) {
    this.readAs.addEventListener("click", readAs);
    this.problems.addEventListener("click", () => {
      nextDiagnostic(view());
      view().focus();
    });
    this.dom = element("footer", { class: "code-status" }, this.problems, this.times, this.place, this.dialect, this.readAs);
    this.problems.hidden = true;
    this.place.title = words.placeTitle;
  }

  showProblems({ errors, warnings, checking, isNotLoaded }: Problems): void {
    const found = isNotLoaded && errors + warnings === 0 ? texts.folder.notChecked : words.problems(errors, warnings);
    this.problems.textContent = checking ? words.checking : found;
    this.problems.disabled = errors + warnings === 0;
    this.problems.dataset.worst = errors > 0 ? "error" : warnings > 0 ? "warning" : "none";
    this.problems.hidden = false;
  }

  /** Shows whether times of lines are missing. */
  showTimes(areLacking: boolean): void {
    this.times.hidden = !areLacking;
  }

  /** Shows line and column of the cursor, from 1 on. */
  showLocation(line: number, column: number): void {
    this.place.textContent = words.place(line, column);
  }

  /** Shows the dialect. `isOffered`: the program looks like that dialect but is read in the other one. */
  showDialect(title: string, isOffered: boolean): void {
    this.dialect.hidden = isOffered;
    this.readAs.hidden = !isOffered;
    this.readAs.textContent = words.readAs(title);
    this.dialect.textContent = title;
    this.dialect.title = words.dialectTitle;
  }
}

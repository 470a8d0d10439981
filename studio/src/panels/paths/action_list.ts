// Actions at a point, in order: names, with the usual ones as suggestions.

import { element } from "../../core/dom";
import { texts } from "../../texts";
import { row } from "./fields";

const words = texts.paths.form;
const commonActions = ["waterjet_on", "waterjet_off", "abrasive_on", "abrasive_off"];
/** Each list of suggestions has its own id. */
let listCount = 0;

export class ActionList {
  readonly element: HTMLElement;
  private actions: readonly string[] = [];
  private readonly listId = `path-actions-${++listCount}`;
  private readonly list = element("span", { class: "chips" });
  private readonly input = element("input", {
    class: "text",
    list: this.listId,
    "aria-label": words.newAction,
    placeholder: words.newAction,
    autocomplete: "off",
    onkeydown: (event) => {
      if ((event as KeyboardEvent).key !== "Enter") return;
      event.preventDefault();
      this.add();
    },
  });

  constructor(private readonly change: (actions: string[]) => void) {
    const listedOptions = element("datalist", { id: this.listId }, ...commonActions.map((value) => element("option", { value })));
    const button = element("button", { type: "button", title: words.addAction, "aria-label": words.addAction, onclick: () => this.add() }, "+");
    this.element = row(words.actions, this.list, this.input, button, listedOptions);
  }

  private add(): void {
    const name = this.input.value.trim();
    if (!name) return;
    this.input.value = "";
    this.change([...this.actions, name]);
  }

  show(actions: readonly string[]): void {
    if (actions.join("\n") === this.actions.join("\n")) return;
    this.actions = actions;
    this.list.replaceChildren(
      ...actions.map((action, i) =>
        element(
          "button",
          {
            type: "button",
            class: "chip",
            title: words.removeAction(action),
            "aria-label": words.removeAction(action),
            onclick: () => {
              this.input.focus();
              this.change(this.actions.filter((_, k) => k !== i));
            },
          },
          `${action} ×`,
        ),
      ),
    );
  }
}

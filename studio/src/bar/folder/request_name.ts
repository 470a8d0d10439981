// Dialog for the name under which a document is saved in the folder.

import { element } from "../../core/dom";
import { texts } from "../../texts";
import { showDialog } from "../dialog";

const words = texts.folder;

const isValidName = (name: string): boolean =>
  name !== "" && !name.includes("\\") && name.split("/").every((part) => part !== "" && part !== "." && part !== "..");

/** null: not at all. */
export function requestName(name: string, proposal: string): Promise<string | null> {
  return new Promise((resolve) => {
    let chosen: string | null = null;
    const error = element("p", { class: "fault", role: "alert" });
    const input = element("input", { type: "text", value: proposal, required: true, "aria-label": words.nameLabel, spellcheck: "false" });
    const submit = (event: Event) => {
      event.preventDefault();
      const given = input.value.trim();
      error.textContent = isValidName(given) ? "" : words.invalidName;
      if (!isValidName(given)) return input.focus();
      chosen = given;
      dialog.close();
    };
    const form = element(
      "form",
      { class: "asked", onsubmit: submit },
      element("label", {}, element("span", {}, words.nameLabel), input),
      error,
      element(
        "div",
        { class: "answers" },
        element("button", { type: "submit", class: "primary" }, words.save),
        element("button", { type: "button", onclick: () => dialog.close() }, words.cancel),
      ),
    );
    const dialog = showDialog(words.nameTitle(name), [form], () => resolve(chosen));
    input.select();
  });
}

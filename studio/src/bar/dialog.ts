// Dialogs, which stay open until they are closed.

import { element } from "../core/dom";

/** Shows a dialog; `ended` is called after it has been closed by any action. */
export function showDialog(title: string, contents: (Node | string)[], ended: () => void = () => {}): HTMLDialogElement {
  const closed = () => {
    dialog.remove();
    ended();
  };
  const dialog = element("dialog", { "aria-label": title, onclose: closed }, element("h2", {}, title), ...contents);
  document.body.append(dialog);
  dialog.showModal();
  return dialog;
}

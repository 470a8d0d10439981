// Undo and redo: two buttons, and keys, except while text is being written.

import { element } from "../core/dom";
import type { Session } from "../core/session";
import type { Store } from "../core/store";
import { texts } from "../texts";

const t = texts.bar;

// Text fields have an undo of their own; these types have none.
const boxes = ":is([type=checkbox], [type=radio], [type=range], [type=button])";
const textInputSelector = `input:not(${boxes}), textarea, [contenteditable], .cm-editor`;

/** Returns which of the two a key requests. */
function requestedAction(event: KeyboardEvent): "undo" | "redo" | null {
  if (event.defaultPrevented || event.altKey || !(event.ctrlKey || event.metaKey)) return null;
  const key = event.key.toLowerCase();
  if (key === "z") return event.shiftKey ? "redo" : "undo";
  return key === "y" && !event.shiftKey ? "redo" : null;
}

export function createUndo(store: Store, session: Session): HTMLElement {
  const { history } = session;
  let said = "";
  const go = (way: "undo" | "redo") => {
    const label = way === "undo" ? history.undoLabel : history.redoLabel;
    if (!label) return;
    history[way]();
    said = way === "undo" ? t.undone(label) : t.redone(label);
    store.set("notice", said);
  };
  // They are never disabled, so that they keep the focus if no step is left.
  const button = (way: "undo" | "redo", sign: string) => element("button", { id: `${way}-button`, onclick: () => go(way) }, sign);
  const [undo, redo] = [button("undo", "↶"), button("redo", "↷")];
  const show = (one: HTMLElement, title: string, label: string) => {
    one.title = title;
    one.setAttribute("aria-label", title);
    one.setAttribute("aria-disabled", String(!label));
  };
  const refresh = () => {
    show(undo, t.undoTitle(history.undoLabel), history.undoLabel);
    show(redo, t.redoTitle(history.redoLabel), history.redoLabel);
  };
  history.on(() => {
    refresh();
    // The notice of a previous step does not apply to this one.
    if (said && store.get("notice") === said) store.set("notice", "");
  });
  refresh();
  document.addEventListener("keydown", (event) => {
    const way = requestedAction(event);
    // An open dialog concerns data that the page must leave unchanged.
    if (!way || (event.target as Element).closest?.(textInputSelector) || document.querySelector("dialog[open]")) return;
    event.preventDefault();
    go(way);
  });
  return element("span", { class: "undo" }, undo, redo);
}

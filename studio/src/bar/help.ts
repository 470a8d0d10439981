// Help on keys.

import { element } from "../core/dom";
import { texts } from "../texts";

/** Shows the help. `isServed`: the page is connected to gsim-studio. */
export function showHelp(isServed: boolean): void {
  const t = texts.bar;
  const keys = isServed ? [...t.keys, texts.folder.saveKey] : t.keys;
  const rows = keys.map(([keys, what]) =>
    element("tr", {}, element("th", { scope: "row" }, element("kbd", {}, keys)), element("td", {}, what)),
  );
  const dialog = element(
    "dialog",
    { "aria-label": t.helpTitle, onclose: () => dialog.remove() },
    element("h2", {}, t.helpTitle),
    element("table", {}, element("tbody", {}, ...rows)),
    element("p", {}, isServed ? texts.folder.private : t.private),
    element("button", { onclick: () => dialog.close() }, t.close),
  );
  document.body.append(dialog);
  dialog.showModal();
}

// Which keys do what.

import { element } from "../core/dom";
import { texts } from "../texts";

export function showHelp(): void {
  const t = texts.bar;
  const rows = t.keys.map(([keys, what]) =>
    element("tr", {}, element("th", { scope: "row" }, element("kbd", {}, keys)), element("td", {}, what)),
  );
  const dialog = element(
    "dialog",
    { "aria-label": t.helpTitle, onclose: () => dialog.remove() },
    element("h2", {}, t.helpTitle),
    element("table", {}, element("tbody", {}, ...rows)),
    element("p", {}, t.private),
    element("button", { onclick: () => dialog.close() }, t.close),
  );
  document.body.append(dialog);
  dialog.showModal();
}

// Pairs of bodies that may touch.

import { arrange, choice, element, setOptions } from "../../../core/dom";
import { texts } from "../../../texts";
import type { FileRole } from "../file/model";
import type { Context, Section } from "../form/context";
import { bodyNames } from "./list";
import { ignoredPairs } from "./tree";

const words = texts.machine.pairs;

export function createPairs(context: Context, part: FileRole): Section {
  const list = element("ul", { class: "pairs" });
  const rows = new Map<string, HTMLElement>();
  const [first, second] = [words.first, words.second].map((label) => choice(label, [], "", () => {}));
  const error = element("p", { class: "key-fault", role: "alert" });
  const pairs = () => ignoredPairs(context.model.value(part));
  const edit = async (what: string, change: Parameters<typeof context.edits.change>[2][number]) => {
    error.textContent = await context.edits.change(part, texts.machine.changed(words.title, what), [change]);
  };
  const add = () => {
    if (first.value === second.value) return void (error.textContent = words.twice);
    void edit(words.added, { op: "add", at: ["ignore"], value: [first.value, second.value] });
  };
  const remove = (text: string) => {
    const at = pairs().findIndex((pair) => pair.join(" – ") === text);
    if (at >= 0) void edit(words.removed, { op: "remove", at: ["ignore", at] });
  };
  const createRow = (text: string) => {
    const button = element("button", { type: "button", "aria-label": words.remove(text), onclick: () => remove(text) }, "×");
    return element("li", {}, text, button);
  };
  return {
    element: element(
      "div",
      {},
      element("p", { class: "note" }, words.about),
      list,
      element("div", { class: "buttons" }, first, second, element("button", { type: "button", onclick: add }, words.add)),
      error,
    ),
    draw() {
      const texts = [...new Set(pairs().map((pair) => pair.join(" – ")))];
      for (const text of texts) if (!rows.has(text)) rows.set(text, createRow(text));
      for (const text of [...rows.keys()]) if (!texts.includes(text)) rows.delete(text);
      arrange(list, texts.map((text) => rows.get(text)!));
      const names = bodyNames(context, part).map((name): [string, string] => [name, name]);
      for (const select of [first, second]) setOptions(select, names, select.value || (names[0]?.[0] ?? ""));
    },
  };
}

// All events of a run, in the order of time.

import { choice, element } from "../../../core/dom";
import { eventText } from "../../../core/names";
import type { Store } from "../../../core/store";
import { markKinds, marksOf, type Mark } from "../../../run/marks";
import { texts } from "../../../texts";
import type { Tab } from "../context";
import { itemList, markItem } from "../mark_list";

const words = texts.panels;

/** Returns the own kind of events, and the section name of all other marks. */
const nameOf = (mark: Mark) => (mark.kind === "event" ? eventText(mark.text) : words.sections[mark.kind]);

export function createEvents(store: Store): Tab {
  const host = element("div", {});
  let wanted = "";
  return {
    element: host,
    draw({ run, index }) {
      const marks = marksOf(run, index);
      const rank = (name: string) => markKinds.findIndex((kind) => words.sections[kind] === name);
      const names = [...new Set(marks.map(nameOf))].sort((a, b) => rank(b) - rank(a) || a.localeCompare(b));
      if (!names.includes(wanted)) wanted = "";
      const list = element("div", {});
      const show = () => {
        const shown = marks.filter((mark) => wanted === "" || nameOf(mark) === wanted);
        list.replaceChildren(itemList(words.tabs.events, shown.map((mark) => markItem(mark, store)), 200));
      };
      const options = [["", words.allKinds], ...names.map((name) => [name, name])] as [string, string][];
      const kinds = choice(words.eventKind, options, wanted, (value) => {
        wanted = value;
        show();
      });
      show();
      host.replaceChildren(...(marks.length > 0 ? [kinds, list] : [element("p", { class: "note" }, words.noEvents)]));
    },
  };
}

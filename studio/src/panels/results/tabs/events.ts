// All events of a run, in the order of time.

import { eventText } from "../../../core/display_names";
import { choice, element } from "../../../core/dom";
import type { Store } from "../../../core/store";
import { markKinds, runMarks, type Mark } from "../../../run/marks";
import { texts } from "../../../texts";
import type { Tab } from "../context";
import { itemList, markItem } from "../mark_list";

const words = texts.panels;

/** Returns the own kind of events, and the section name of all other marks. */
const nameOf = (mark: Mark) => (mark.kind === "event" ? eventText(mark.text) : words.sections[mark.kind]);

export function createEvents(store: Store): Tab {
  const host = element("div", {});
  let requested = "";
  return {
    element: host,
    draw({ run, index }) {
      const marks = runMarks(run, index);
      const rank = (name: string) => markKinds.findIndex((kind) => words.sections[kind] === name);
      const names = [...new Set(marks.map(nameOf))].sort((a, b) => rank(b) - rank(a) || a.localeCompare(b));
      if (!names.includes(requested)) requested = "";
      const list = element("div", {});
      const show = () => {
        const displayed = marks.filter((mark) => requested === "" || nameOf(mark) === requested);
        list.replaceChildren(itemList(words.tabs.events, displayed.map((mark) => markItem(mark, store)), 200));
      };
      const options = [["", words.allKinds], ...names.map((name) => [name, name])] as [string, string][];
      const kinds = choice(words.eventKind, options, requested, (value) => {
        requested = value;
        show();
      });
      show();
      host.replaceChildren(...(marks.length > 0 ? [kinds, list] : [element("p", { class: "note" }, words.noEvents)]));
    },
  };
}

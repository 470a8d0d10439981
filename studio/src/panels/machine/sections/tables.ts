// Tables of a machine file with a fixed set of keys: its name, limits of the path, process, times.

import { element } from "../../../core/dom";
import { texts } from "../../../texts";
import { tableAt } from "../file/toml";
import type { Context, Section } from "../form/context";
import type { Key } from "../form/key_schema";
import { WordRows } from "../form/word_rows";
import { ZERO_POSE, Rows, keyDefaults, poseRows, fieldSpec } from "../form/rows";

const words = texts.machine;

/**
 * Creates the keys of one table of the machine's file; keys of a form such as M100 are in a list that grows.
 */
export function createTable(context: Context, name: string, title: string, all: Key[]): Section {
  const keys = all.filter(({ pattern }) => !pattern);
  const home = () => ({ part: "machine" as const, at: [name], owner: title });
  const rows = new Rows(context, Object.fromEntries(keys.map((key) => [key.name, fieldSpec(key)])), home);
  const patternKey = all.find(({ pattern }) => pattern);
  const more = patternKey && { form: new RegExp(patternKey.pattern!), rows: new WordRows(context, { ...fieldSpec(patternKey), unit: "s" }, 1, home) };
  const defaults = keyDefaults(keys);
  return {
    element: element("div", {}, element("h4", {}, title), rows.element, ...(more ? [more.rows.element] : [])),
    draw() {
      const table = tableAt(context.model.value("machine"), [name]);
      rows.show(table, defaults);
      more?.rows.show(Object.fromEntries(Object.entries(table).filter(([key]) => more.form.test(key))));
    },
  };
}

/** Creates the section of a fixed frame. */
export function createFrame(context: Context, name: "base" | "tool" | "work"): Section {
  const title = words.frames[name];
  const rows = poseRows(context, () => ({ part: "machine", at: [name], owner: title }));
  return {
    element: element("div", {}, element("h4", {}, title), rows.element),
    draw: () => rows.show(tableAt(context.model.value("machine"), [name]), ZERO_POSE),
  };
}

// Changes of values in a JSON text that keep the layout of all other parts.

import { texts } from "../texts";

export type JsonValue = null | boolean | number | string | JsonValue[] | { [key: string]: JsonValue | undefined };
/** Keys and indices from the outermost value to one within it. */
export type JsonPath = readonly (string | number)[];

/** Error of a text that is not JSON: its position (characters from the start), and the reason. */
export class JsonError extends Error {
  constructor(
    readonly at: number,
    message: string,
  ) {
    super(message);
  }
}

/** Part of a text, from one character to before another. */
interface Span {
  from: number;
  to: number;
}
interface Member extends Span {
  key: string;
  keyStart: number;
}

const words = texts.json;
const MAX_LEVELS = 500;
const SPACE = /[ \t\r\n]*/y;
const NUMBER = /-?(0|[1-9]\d*)(\.\d+)?([eE][+-]?\d+)?/y;
const STRING = /"[^"\\\u0000-\u001f]*(?:\\(?:["\\/bfnrt]|u[0-9a-fA-F]{4})[^"\\\u0000-\u001f]*)*"/y;
const WORD = /true|false|null/y;

/** Returns the end of a sticky pattern that begins at a position; -1: no match. */
function matchEnd(pattern: RegExp, text: string, at: number): number {
  pattern.lastIndex = at;
  return pattern.test(text) ? pattern.lastIndex : -1;
}

const skipSpace = (text: string, at: number): number => matchEnd(SPACE, text, at);

/** Receiver of the members of an object or a list. */
interface Visitor {
  /** Called before a member's value is scanned; false: stop. */
  onBegin(member: Member): boolean;
  /** Called after it. */
  ends(to: number): void;
}

const NULL_VISITOR: Visitor = { onBegin: () => true, ends: () => undefined };

/** Returns the end of a value that begins at a position. */
function valueEnd(text: string, at: number, level = 0): number {
  if (level > MAX_LEVELS) throw new JsonError(at, words.tooDeep);
  if (text[at] === "{") return visit(text, at, "}", NULL_VISITOR, level);
  if (text[at] === "[") return visit(text, at, "]", NULL_VISITOR, level);
  const pattern = text[at] === '"' ? STRING : /[-\d]/.test(text[at] ?? "") ? NUMBER : WORD;
  const end = matchEnd(pattern, text, at);
  if (end < 0) throw new JsonError(at, at >= text.length ? words.endsTooSoon : words.value);
  return end;
}

/** Returns the end of a key. */
function keyEnd(text: string, at: number): number {
  const end = text[at] === '"' ? matchEnd(STRING, text, at) : -1;
  if (end < 0) throw new JsonError(at, at >= text.length ? words.endsTooSoon : words.key);
  return end;
}

/** Scans an object or a list; returns its end, or -1: the visitor stopped. */
function visit(text: string, from: number, close: string, visitor: Visitor, level = 0): number {
  let at = skipSpace(text, from + 1);
  if (text[at] === close) return at + 1;
  for (;;) {
    const keyStart = at;
    let key = "";
    if (close === "}") {
      const end = keyEnd(text, at);
      key = JSON.parse(text.slice(at, end)) as string;
      at = skipSpace(text, end);
      if (text[at] !== ":") throw new JsonError(at, words.colon);
      at = skipSpace(text, at + 1);
    }
    if (!visitor.onBegin({ key, keyStart, from: at, to: -1 })) return -1;
    const to = valueEnd(text, at, level + 1);
    visitor.ends(to);
    at = skipSpace(text, to);
    if (text[at] === close) return at + 1;
    if (text[at] !== ",") throw new JsonError(at, at >= text.length ? words.endsTooSoon : words.commaOr(close));
    at = skipSpace(text, at + 1);
  }
}

const visitChildren = (text: string, from: number, visitor: Visitor): void => {
  const close = { "{": "}", "[": "]" }[text[from]];
  if (close) visit(text, from, close, visitor);
};

/** Returns the members of an object or a list that begins at a position. */
function readChildren(text: string, from: number): Member[] {
  const members: Member[] = [];
  visitChildren(text, from, { onBegin: (member) => members.push(member) > 0, ends: (to) => (members[members.length - 1].to = to) });
  return members;
}

/** Returns the start of a member; text after it is not scanned. */
function childStart(text: string, from: number, step: string | number): number {
  let found = -1;
  let index = -1;
  const onBegin = (member: Member) => {
    ++index;
    if (member.key === step || (typeof step === "number" && index === step)) found = member.from;
    return found < 0;
  };
  visitChildren(text, from, { onBegin, ends: () => undefined });
  if (found < 0) throw new JsonError(from, words.noMember(String(step)));
  return found;
}

/** Returns the value of a complete text; throws a JsonError. */
export function readJson(text: string): JsonValue {
  const from = skipSpace(text, 0);
  const rest = skipSpace(text, valueEnd(text, from));
  if (rest < text.length) throw new JsonError(rest, words.behindEnd);
  return JSON.parse(text) as JsonValue;
}

/** Returns the position of a value; throws a JsonError if it does not exist. */
export function valueSpan(text: string, place: JsonPath): Span {
  const from = place.reduce<number>((at, step) => childStart(text, at, step), skipSpace(text, 0));
  return { from, to: valueEnd(text, from) };
}

/** Returns a value on one line: {"a": [1, 2]}. Undefined values are omitted. */
export function jsonLine(value: JsonValue): string {
  if (Array.isArray(value)) return `[${value.map(jsonLine).join(", ")}]`;
  if (value === null || typeof value !== "object") return JSON.stringify(value);
  const members = Object.entries(value).filter((member): member is [string, JsonValue] => member[1] !== undefined);
  return `{${members.map(([key, each]) => `${JSON.stringify(key)}: ${jsonLine(each)}`).join(", ")}}`;
}

const splice = (text: string, from: number, to: number, by: string): string => text.slice(0, from) + by + text.slice(to);

/** Formats a value like its neighbours: on one line, or with a line for each member. */
function formatLike(value: JsonValue, neighbour: string, indent: string): string {
  if (!neighbour.includes("\n")) return jsonLine(value);
  return JSON.stringify(value, null, 2).replaceAll("\n", `\n${indent}`);
}

/** Returns the text between a member and its predecessor: spaces, mostly an end of line. */
function gapBefore(text: string, at: number): string {
  let from = at;
  while (from > 0 && " \t\r\n".includes(text[from - 1])) --from;
  return text.slice(from, at);
}

/** Returns the indentation of the line at a position. */
function indentAt(text: string, at: number): string {
  const from = text.lastIndexOf("\n", at - 1) + 1;
  return text.slice(from, matchEnd(/[ \t]*/y, text, from));
}

/** Changes the text of the value at this position. */
export function changeValue(text: string, place: JsonPath, change: (value: string) => string): string {
  const { from, to } = valueSpan(text, place);
  return splice(text, from, to, change(text.slice(from, to)));
}

/** Replaces the value at this position. */
export function replaceValue(text: string, place: JsonPath, value: JsonValue): string {
  const { from } = valueSpan(text, place);
  return changeValue(text, place, (before) => formatLike(value, before, indentAt(text, from)));
}

/**
 * Sets a member of an object; undefined removes it. A new one is inserted after those that precede it in
 * `order`.
 */
export function setMember(text: string, place: JsonPath, key: string, value: JsonValue | undefined, order: readonly string[]): string {
  const object = valueSpan(text, place);
  const members = readChildren(text, object.from);
  const at = members.findIndex((member) => member.key === key);
  if (at >= 0) return value === undefined ? removeChildren(text, members, at, 1) : replaceValue(text, [...place, key], value);
  if (value === undefined) return text;
  const rank = (name: string) => (order.includes(name) ? order.indexOf(name) : order.length);
  const before = members.findLastIndex((member) => rank(member.key) <= rank(key));
  return insertChildren(text, object, members, before + 1, [`${JSON.stringify(key)}: ${jsonLine(value)}`]);
}

/** Inserts values into a list at an index, as they are written. */
export function insertTexts(text: string, place: JsonPath, index: number, written: readonly string[]): string {
  const list = valueSpan(text, place);
  return insertChildren(text, list, readChildren(text, list.from), index, written);
}

/** Inserts values into a list at an index, formatted like the previous one. */
export function insertItems(text: string, place: JsonPath, index: number, values: readonly JsonValue[]): string {
  const neighbour = readChildren(text, valueSpan(text, place).from)[Math.max(index - 1, 0)];
  const like = neighbour ? text.slice(neighbour.from, neighbour.to) : "";
  const indent = neighbour ? indentAt(text, neighbour.from) : "";
  return insertTexts(text, place, index, values.map((value) => formatLike(value, like, indent)));
}

/** Returns the texts of some items of a list. */
export const itemTexts = (text: string, place: JsonPath, first: number, count: number): string[] =>
  readChildren(text, valueSpan(text, place).from)
    .slice(first, first + count)
    .map(({ from, to }) => text.slice(from, to));

/** Removes items from a list. */
export const removeItems = (text: string, place: JsonPath, first: number, count: number): string =>
  removeChildren(text, readChildren(text, valueSpan(text, place).from), first, count);

/** Reorders the items of a list: `order` has the previous index of each item. */
export function reorderItems(text: string, place: JsonPath, order: readonly number[]): string {
  const items = readChildren(text, valueSpan(text, place).from);
  const pieces: string[] = [];
  let at = 0;
  items.forEach(({ from, to }, i) => {
    const taken = items[order[i]];
    pieces.push(text.slice(at, from), text.slice(taken.from, taken.to));
    at = to;
  });
  return pieces.join("") + text.slice(at);
}

function insertChildren(text: string, parent: Span, children: Member[], index: number, written: readonly string[]): string {
  if (children.length === 0) return splice(text, parent.from + 1, parent.to - 1, written.join(", "));
  const gap = gapBefore(text, children[children.length > 1 ? 1 : 0].keyStart);
  // A single member directly after its bracket, as in "{}", has no gap to copy.
  const between = children.length > 1 || gap ? gap : " ";
  if (index === 0) {
    const first = children[0].keyStart;
    return splice(text, first, first, written.map((each) => `${each},${between}`).join(""));
  }
  const { to } = children[index - 1];
  return splice(text, to, to, written.map((each) => `,${between}${each}`).join(""));
}

function removeChildren(text: string, children: Member[], first: number, count: number): string {
  const next = children[first + count];
  if (next) return splice(text, children[first].keyStart, next.keyStart, "");
  const from = first > 0 ? children[first - 1].to : children[0].keyStart;
  return splice(text, from, children[first + count - 1].to, "");
}

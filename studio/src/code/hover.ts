// Card next to a word under the pointer: its meaning, the data of its block, the active modal codes.

import { StateEffect, StateField, type Extension } from "@codemirror/state";
import { closeHoverTooltips, hoverTooltip, keymap, showTooltip, type EditorView, type Tooltip } from "@codemirror/view";
import { element } from "../core/dom";
import type { Code } from "../core/languages";
import { limitText } from "../core/display_names";
import { shownRobot } from "../core/display_state";
import type { Store } from "../core/store";
import { feedText, lengthText, percentText, timeText } from "../core/units";
import { texts } from "../texts";
import { blockSummary, isSummaryIncomplete, type BlockSummary } from "./block_summary";
import { codeName, type Dialect } from "./dialect";
import type { ModalState } from "./modal";
import { isCode, parseWords } from "./words";

const words = texts.code.hover;

/** Data that an editor needs for its hover cards. */
export interface HoverContext {
  store: Store;
  dialect(): Dialect;
  /** Returns file and line of the shown run for a line of this text; null: it has not run. */
  runLocation(line: number): { file: number; line: number } | null;
  /** Returns the active codes after a line; null: unknown. */
  modal(line: number): Promise<ModalState | null>;
  /** True for Lua: words are functions of the library. */
  isLua: boolean;
}

function codeParameters(code: Code, dialect: Dialect): string {
  const letters = [...code.words].map((letter) => ({ "=": "AR=", ",": ",C ,R ,A" })[letter] ?? letter);
  return [...(code.axes ? [[...dialect.axes].join(" ")] : []), ...letters].join(" ");
}

/** Creates a card with a code's meaning and its words. */
export function codeCard(code: Code, dialect: Dialect): HTMLElement {
  const card = element("div", { class: "code-card" }, element("b", {}, code.code), ` ${code.meaning}`);
  const taken = codeParameters(code, dialect);
  const lines = [
    code.group ? words.group(code.group) : words.blockAlone,
    taken && words.takes(taken),
    !code.supported && words.refused,
  ];
  for (const line of lines) if (line) card.append(element("div", { class: "code-dim" }, line));
  return card;
}

const said = (title: string, text: string) => element("div", { class: "code-card" }, element("b", {}, title), ` ${text}`);

function gcodeWordCard(line: string, column: number, dialect: Dialect): HTMLElement | null {
  const word = parseWords(line, dialect.properties.semicolonComments).find(({ from, to }) => from <= column && column <= to);
  if (!word) return null;
  if (isCode(word)) {
    const name = codeName(word.letter, word.number);
    const code = dialect.codes.get(name);
    if (code) return codeCard(code, dialect);
    return dialect.isUnknown(name) ? said(name, words.unknown) : null;
  }
  const meaning = dialect.letters.get(word.letter);
  return meaning ? said(word.letter, meaning) : null;
}

function luaWordCard(line: string, column: number, dialect: Dialect): HTMLElement | null {
  for (const { 0: name, index } of line.matchAll(/[A-Za-z_]\w*/g)) {
    if (column < index || column > index + name.length) continue;
    const code = dialect.functions.get(name);
    if (code) return codeCard(code, dialect);
    const meaning = dialect.letters.get(name.toUpperCase());
    return meaning ? said(name, meaning) : null;
  }
  return null;
}

function summaryCard(summary: BlockSummary, { store }: HoverContext): HTMLElement {
  const units = store.get("units");
  const share = percentText(summary.time_s, store.get("run")!.end_s);
  const card = element("div", { class: "code-card" });
  const passes = summary.passes > 1 ? ` ${words.passes(summary.passes)}` : "";
  card.append(element("div", {}, `${words.share(timeText(summary.time_s), share)}${passes}`));
  if (summary.length_mm > 0) {
    const length = lengthText(summary.length_mm, units);
    card.append(element("div", {}, words.way(length, feedText(summary.peak_mm_s, units))));
  }
  card.append(element("div", {}, words.limitedBy(limitText(summary.limit))));
  return card;
}

function modalCard(state: ModalState, dialect: Dialect): HTMLElement {
  const list = element("div", { class: "code-modal" });
  for (const [group, name] of state.codes) {
    const meaning = dialect.codes.get(name)?.meaning ?? "";
    list.append(element("span", { title: `${group}: ${meaning}` }, name), " ");
  }
  for (const [letter, value] of state.words) list.append(element("span", {}, letter + value), " ");
  const title = state.jumps ? words.inForceByText : words.activeAfterLine;
  return element("div", { class: "code-card" }, element("div", { class: "code-dim" }, title), list);
}

/** Returns the data of a line's block, or the reason why they are missing; null: it has not run. */
function createSummaryCard(context: HoverContext, line: number): HTMLElement | null {
  const place = context.runLocation(line);
  const robot = shownRobot(context.store);
  if (!place || !robot) return null;
  if (isSummaryIncomplete(robot, place.file, place.line)) return element("div", { class: "code-card code-dim" }, words.notHere);
  const summary = blockSummary(robot, place.file, place.line);
  return summary && summaryCard(summary, context);
}

async function createHoverCards(context: HoverContext, view: EditorView, position: number): Promise<HTMLElement | null> {
  const line = view.state.doc.lineAt(position);
  if (line.text.trim() === "") return null;
  const dialect = context.dialect();
  const column = position - line.from;
  const word = context.isLua ? luaWordCard(line.text, column, dialect) : gcodeWordCard(line.text, column, dialect);
  const summary = createSummaryCard(context, line.number);
  const state = await context.modal(line.number);
  const all = element("div", { class: "code-hover" });
  if (word) all.append(word);
  if (summary) all.append(summary);
  if (state && (state.codes.size > 0 || state.words.size > 0)) all.append(modalCard(state, dialect));
  return all.childElementCount > 0 ? all : null;
}

async function tooltip(context: HoverContext, view: EditorView, pos: number): Promise<Tooltip | null> {
  const dom = await createHoverCards(context, view, pos);
  return dom && { pos, above: true, create: () => ({ dom }) };
}

const setCursorTooltip = StateEffect.define<Tooltip | null>();

/** Cards of the word at the cursor, for users without a pointer, until the cursor or the text moves. */
const cursorTooltip = StateField.define<Tooltip | null>({
  create: () => null,
  update(displayed, { effects, selection, docChanged }) {
    if (selection || docChanged) displayed = null;
    for (const effect of effects) if (effect.is(setCursorTooltip)) displayed = effect.value;
    return displayed;
  },
  provide: (own) => showTooltip.from(own),
});

function showCursorTooltip(context: HoverContext, view: EditorView): boolean {
  const { state } = view;
  void tooltip(context, view, state.selection.main.head).then((shown) => {
    const isSame = view.state.doc === state.doc && view.state.selection.eq(state.selection);
    if (isSame) view.dispatch({ effects: [closeHoverTooltips, setCursorTooltip.of(shown)] });
  });
  return true;
}

function hideCursorTooltip(view: EditorView): boolean {
  if (!view.state.field(cursorTooltip)) return false;
  view.dispatch({ effects: setCursorTooltip.of(null) });
  return true;
}

/** Shows the cards as a tooltip of an editor: under the pointer, and at the cursor by Ctrl+I. */
export const hover = (context: HoverContext): Extension => [
  hoverTooltip((view, position) => tooltip(context, view, position), { hoverTime: 350, hideOnChange: true }),
  cursorTooltip,
  keymap.of([
    { key: "Mod-i", run: (view) => showCursorTooltip(context, view), preventDefault: true },
    { key: "Escape", run: hideCursorTooltip },
  ]),
];

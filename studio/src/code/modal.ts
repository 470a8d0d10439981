// Modal state at a line, from the text above it: the last code of each modal group, F, S and T. It is stored
// at every thousandth line, so that a query far down a long program does not read all of it again.

import type { Text } from "@codemirror/state";
import { codeName, isModal, type Dialect } from "./dialect";
import { isCode, withoutComments, parseWords } from "./words";

export interface ModalState {
  /** Name of the code by group. */
  codes: Map<string, string>;
  /** "F", "S" and "T" as written. */
  words: Map<string, string>;
  /** True if the text has subprograms, jumps or loops, so that it is less informative than a run. */
  jumps: boolean;
}

const STATE_INTERVAL_LINES = 1000;
/** Lines between two pauses that keep the page responsive. */
const LINES_PER_SLICE = 20_000;
/** Programs up to so many lines are searched to their end for jumps. */
const MAX_JUMP_SEARCH_LINES = 20_000;

const jump = /\bM\s*9[89]\b|\bG\s*6[56]\b|\bGOTO\b|\bWHILE\b|^\s*(?:N\d+\s*)?O\s*[<\d#]/i;

const pause = () => new Promise((go) => setTimeout(go));

export class ModalIndex {
  /** State before line 1 + STATE_INTERVAL_LINES * i. */
  private states: ModalState[];
  private hasJumpsInText: boolean | null = null;

  constructor(private readonly dialect: Dialect) {
    this.states = [this.initialState()];
  }

  /** Discards states that a change from this line on may have invalidated. */
  changed(line: number): void {
    this.states.length = Math.min(this.states.length, Math.floor((line - 1) / STATE_INTERVAL_LINES) + 1);
    this.hasJumpsInText = null;
  }

  /** Returns the state when `line` begins, or after it. Null: the text has changed meanwhile. */
  async at(doc: Text, line: number, isStale: () => boolean): Promise<ModalState | null> {
    const requested = Math.floor(line / STATE_INTERVAL_LINES);
    while (this.states.length <= requested) {
      const first = this.states.length;
      this.states.push(this.read(doc, this.states[first - 1], (first - 1) * STATE_INTERVAL_LINES + 1, first * STATE_INTERVAL_LINES));
      if ((first * STATE_INTERVAL_LINES) % LINES_PER_SLICE !== 0) continue;
      await pause();
      if (isStale()) return null;
    }
    const state = this.read(doc, this.states[requested], requested * STATE_INTERVAL_LINES + 1, line);
    if (doc.lines <= MAX_JUMP_SEARCH_LINES) state.jumps = this.hasJumps(doc);
    return state;
  }

  private hasJumps(doc: Text): boolean {
    if (this.hasJumpsInText !== null) return this.hasJumpsInText;
    this.hasJumpsInText = false;
    for (const text of doc.iterLines()) {
      if (this.isJump(text)) this.hasJumpsInText = true;
    }
    return this.hasJumpsInText;
  }

  // The number of the program itself is not a jump.
  private isJump(text: string): boolean {
    const bare = withoutComments(text, this.dialect.properties.semicolonComments);
    return jump.test(bare) && !/^\s*O\s*\d+\s*$/i.test(bare);
  }

  private initialState(): ModalState {
    const state: ModalState = { codes: new Map(), words: new Map(), jumps: false };
    for (const name of this.dialect.initial) this.applyCode(state, name);
    return state;
  }

  private applyCode(state: ModalState, name: string): void {
    const code = this.dialect.codes.get(name);
    if (code && isModal(code)) state.codes.set(code.group!, name);
  }

  private read(doc: Text, before: ModalState, from: number, to: number): ModalState {
    const state: ModalState = { codes: new Map(before.codes), words: new Map(before.words), jumps: before.jumps };
    if (from > to || from > doc.lines) return state;
    for (const text of doc.iterLines(from, Math.min(to, doc.lines) + 1)) {
      if (/[GMFST]/i.test(text)) this.readLine(state, text);
      state.jumps ||= this.isJump(text);
    }
    return state;
  }

  private readLine(state: ModalState, text: string): void {
    for (const word of parseWords(text, this.dialect.properties.semicolonComments)) {
      if (isCode(word)) this.applyCode(state, codeName(word.letter, word.number));
      else if ("FST".includes(word.letter)) state.words.set(word.letter, word.number || "[..]");
    }
  }
}

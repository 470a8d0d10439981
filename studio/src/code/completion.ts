// Completion of typed text: codes with their meaning, and words that belong to the codes of the block.

import {
  autocompletion,
  type Completion,
  type CompletionContext,
  type CompletionResult,
} from "@codemirror/autocomplete";
import type { Extension } from "@codemirror/state";
import type { Code } from "../core/languages";
import { texts } from "../texts";
import { codeName, type Dialect } from "./dialect";
import { codeCard } from "./hover";
import { luaKeywords } from "./lua_language";
import { isCode, withoutComments, parseWords } from "./words";

const codeOption = (code: Code, dialect: Dialect, label: string): Completion => ({
  label,
  detail: code.supported ? code.meaning : `${code.meaning} (${texts.code.hover.refused})`,
  type: code.code[0] === "M" ? "function" : "keyword",
  info: () => codeCard(code, dialect),
});

/** Creates an option for a letter; options are ordered by `index`, not alphabetically. */
const letterOption = (dialect: Dialect, letter: string, index = 0): Completion => ({
  label: letter,
  boost: 99 - index,
  detail: dialect.letters.get(letter) ?? "",
  type: "variable",
});

/** Returns the letters of the codes in the line; without codes, or with axis words alone, all letters. */
function lettersOfLine(line: string, dialect: Dialect): string[] {
  const words = parseWords(line, dialect.properties.semicolonComments);
  const present = new Set(words.map(({ letter }) => letter));
  const codes = words.filter(isCode).flatMap(({ letter, number }) => {
    const code = dialect.codes.get(codeName(letter, number));
    return code ? [code] : [];
  });
  const letters = codes.flatMap((code) => [
    ...(code.axes ? dialect.axes : []),
    ...[...code.words].flatMap((letter) => ({ "=": ["AR="], ",": [",C", ",R", ",A"] })[letter] ?? [letter]),
  ]);
  const requested = letters.length > 0 ? [...new Set([...letters, "F", "S", "T"])] : [...dialect.letters.keys()];
  return requested.filter((letter) => !present.has(letter));
}

function completeGcode(context: CompletionContext, dialect: Dialect): CompletionResult | null {
  const line = context.state.doc.lineAt(context.pos);
  const before = line.text.slice(0, context.pos - line.from);
  // In a comment, the blanked text ends in blanks but the original text does not.
  if (before.trimEnd() !== "" && /\s$/.test(withoutComments(before, dialect.properties.semicolonComments).slice(0, before.trimEnd().length))) {
    return null;
  }
  const word = context.matchBefore(/[GM]\d*\.?\d*/i);
  if (word) {
    const letter = word.text[0].toUpperCase();
    const codes = [...dialect.codes.values()].filter(({ code }) => code[0] === letter);
    const options = codes.map((code) => codeOption(code, dialect, code.code));
    return { from: word.from, options, validFor: /^[GM]\d*\.?\d*$/i };
  }
  if (!context.explicit) return null;
  const options = lettersOfLine(before, dialect).map((letter, i) => letterOption(dialect, letter, i));
  return { from: context.pos, options };
}

function completeLua(context: CompletionContext, dialect: Dialect): CompletionResult | null {
  const word = context.matchBefore(/[A-Za-z_]\w*/);
  if (!word && !context.explicit) return null;
  const options = [
    ...luaKeywords.map((label): Completion => ({ label, type: "keyword" })),
    ...[...dialect.functions.values()].filter(({ supported }) => supported).map((code) => codeOption(code, dialect, code.lua)),
    ...["F", "S", "T"].map((letter) => ({ ...letterOption(dialect, letter), boost: 0 })),
    { label: "move", detail: texts.code.move, type: "function" },
  ];
  return { from: word?.from ?? context.pos, options, validFor: /^\w*$/ };
}

/** Accepts an option by Enter if it was chosen with the arrows; otherwise Enter begins a new line. */
export function completion(dialect: Dialect, isLua: boolean): Extension {
  const source = (context: CompletionContext) => (isLua ? completeLua(context, dialect) : completeGcode(context, dialect));
  return autocompletion({ override: [source], selectOnOpen: false, icons: false });
}

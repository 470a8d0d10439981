// Colours of G-code, from the engine's tables.

import { StreamLanguage, type StringStream } from "@codemirror/language";
import { codeName, type Dialect } from "./dialect";
import { tokenTable } from "./tokens";
import { blockAfterSemicolon } from "./words";

const word = /^([A-Z@^$])\s*([+-]?(?:\d+\.?\d*|\.\d+))/i;
const keyword =
  /^(?:endsub|endif|endwhile|endrepeat|elseif|else|while|repeat|break|continue|return|call|sub|if|goto|then|do|end|and|or|xor|mod|eq|ne|lt|gt|le|ge|abs|acos|asin|atan|bcd|bin|cos|exists|exp|fix|fup|ln|round|sin|sqrt|tan)(?![A-Z_])/i;

function codeTokenType(dialect: Dialect, letter: string, number: string): string {
  const name = codeName(letter, number);
  if (dialect.isUnknown(name)) return "unknown";
  if (letter.toUpperCase() === "M") return "mcode";
  const group = dialect.codes.get(name)?.group;
  if (group === "motion" || group === "canned cycles") return "motion";
  return !group && /^G[0123]$/.test(name) ? "motion" : "gcode";
}

/** Returns the colour of the letter alone: its number has the colour of numbers. */
function letterTokenType(dialect: Dialect, letter: string): string {
  const capital = letter.toUpperCase();
  if (dialect.axes.has(capital)) return "axis";
  return "FST".includes(capital) ? "setting" : "parameter";
}

function comment(stream: StringStream, dialect: Dialect): boolean {
  if (stream.match(/^\([^)]*\)?/)) return true;
  if (stream.peek() !== ";") return false;
  if (!dialect.properties.semicolonComments && stream.match(blockAfterSemicolon, false)) return false;
  stream.skipToEnd();
  return true;
}

function readCodeWord(stream: StringStream, dialect: Dialect): string | null {
  const found = stream.match(word, false) as RegExpMatchArray | null;
  if (!found) return null;
  const letter = found[1].toUpperCase();
  const whole = "GMNO".includes(letter);
  stream.match(whole ? word : /^./);
  if (letter === "N") return "block";
  if (letter === "O") return "oword";
  return whole ? codeTokenType(dialect, letter, found[2]) : letterTokenType(dialect, letter);
}

function token(stream: StringStream, dialect: Dialect): string | null {
  if (stream.eatSpace()) return null;
  if (comment(stream, dialect)) return "comment";
  if (stream.match(/^#+\s*(?:<[^>]*>|\d+)/) || stream.match(/^#/)) return "numbered";
  if (stream.match(/^O\s*(?:<[^>]*>|\d+|#\d+)/i)) return "oword";
  if (stream.match(/^(?:AR=|[IJK]1=|CIP\b|,\s*[CRA])/i)) return "parameter";
  if (stream.match(keyword)) return "keyword";
  const code = readCodeWord(stream, dialect);
  if (code) return code;
  if (stream.match(/^[+-]?(?:\d+\.?\d*|\.\d+)/)) return "number";
  if (stream.match(/^[A-Z_]{2,}\w*/i)) return "name";
  const letter = stream.next()!;
  if (/[A-Z@^$]/i.test(letter)) return letterTokenType(dialect, letter);
  return letter === "%" || letter === "/" ? "block" : null;
}

export function gcodeLanguage(dialect: Dialect): StreamLanguage<unknown> {
  return StreamLanguage.define<unknown>({
    name: dialect.name,
    token: (stream) => token(stream, dialect),
    tokenTable,
  });
}

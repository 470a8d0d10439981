// Words of a line of G-code: a letter and its value. They are only for the editor; the engine decides if a
// line is correct.

/** Word with columns that count from 0; `to` is after the last character. */
export interface Word {
  from: number;
  to: number;
  /** In capitals: "G", "X"; "#" of a setting, "O" of an O-word, "AR=", ",C". */
  letter: string;
  /** Number as it is written; "" for an expression or a variable. */
  number: string;
}

/**
 * In the 9/Series a ';' may also end a block: text after it that begins like this is another block, not a
 * comment.
 */
export const blockAfterSemicolon = /^;\s*[a-z/#]\s*[\d#[]/i;

const commentPattern = /\([^)]*\)?|;.*/g;

/** Returns the line with blanked comments, so that columns stay. */
export function withoutComments(line: string, semicolonComments: boolean): string {
  if (!/[(;]/.test(line)) return line;
  return line.replace(commentPattern, (found) =>
    found[0] === ";" && !semicolonComments && blockAfterSemicolon.test(found) ? found : " ".repeat(found.length),
  );
}

const wordPattern = /(AR=|,\s*[CRA]|[A-Z@^$])\s*([+-]?(?:\d+\.?\d*|\.\d+))?/gi;

/** Names (#<depth>), keywords and functions are not words. */
const nonWordPattern = /#?<[^>]*>|\[[^\]]*\]|[A-Z_]{2,}(?!=)/gi;

export function parseWords(line: string, semicolonComments: boolean): Word[] {
  const blank = (found: string) => (/^AR$/i.test(found) ? found : " ".repeat(found.length));
  const text = withoutComments(line, semicolonComments).replace(nonWordPattern, blank);
  const words: Word[] = [];
  for (const found of text.matchAll(wordPattern)) {
    words.push({
      from: found.index,
      to: found.index + found[0].trimEnd().length,
      letter: found[1].toUpperCase().replace(/\s/g, ""),
      number: found[2] ?? "",
    });
  }
  return words;
}

export const isCode = (word: Word): boolean => (word.letter === "G" || word.letter === "M") && word.number !== "";

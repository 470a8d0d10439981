// Conversion of lines to comments and back. RS274/NGC has ';' to the end of the line. In the 9/Series a block
// may follow it, so there a line is written between '(' and ')'. The brackets of comments in it become '{'
// and '}' meanwhile.

import type { EditorState, Line, StateCommand } from "@codemirror/state";

const parenthesizedLine = /^(\s*)\((.*)\)\s*$/;

const isComment = (text: string, semicolonComments: boolean) => (semicolonComments ? /^\s*;/.test(text) : isSingleComment(text));

// "(A) G1 (B)" begins and ends like a comment, but is none.
function isSingleComment(text: string): boolean {
  const found = parenthesizedLine.exec(text);
  return found !== null && !found[2].includes("(") && !found[2].includes(")");
}

function toComment(text: string, semicolonComments: boolean): string {
  if (semicolonComments) return `; ${text}`;
  return `(${text.replaceAll("(", "{").replaceAll(")", "}")})`;
}

function removeComment(text: string, semicolonComments: boolean): string {
  if (semicolonComments) return text.replace(/^(\s*); ?/, "$1");
  const [, indent, inside] = parenthesizedLine.exec(text)!;
  return indent + inside.replaceAll("{", "(").replaceAll("}", ")");
}

function selectedLines(state: EditorState): Line[] {
  const lines = new Map<number, Line>();
  for (const { from, to } of state.selection.ranges) {
    for (let at = from; ; ) {
      const line = state.doc.lineAt(at);
      if (line.text.trim() !== "") lines.set(line.number, line);
      if (line.to >= to) break;
      at = line.to + 1;
    }
  }
  return [...lines.values()];
}

/**
 * Turns all lines of the selection that are no comments into comments; if all are comments, they become
 * blocks again.
 */
export function toggleLineComment(semicolonComments: boolean): StateCommand {
  return ({ state, dispatch }) => {
    const lines = selectedLines(state);
    if (state.readOnly || lines.length === 0) return false;
    const off = lines.every(({ text }) => isComment(text, semicolonComments));
    const changes = lines
      .filter(({ text }) => off || !isComment(text, semicolonComments))
      .map(({ from, to, text }) => ({ from, to, insert: off ? removeComment(text, semicolonComments) : toComment(text, semicolonComments) }));
    dispatch(state.update({ changes, userEvent: "input.comment" }));
    return true;
  };
}

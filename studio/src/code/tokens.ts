// Kinds of words for colouring. Names that have a meaning in CodeMirror, such as "variable", are not usable.

import { HighlightStyle } from "@codemirror/language";
import { Tag, tags } from "@lezer/highlight";

export const tokenTable = {
  motion: Tag.define(),
  gcode: Tag.define(),
  mcode: Tag.define(),
  unknown: Tag.define(),
  axis: Tag.define(),
  setting: Tag.define(),
  parameter: Tag.define(),
  block: Tag.define(),
  oword: Tag.define(),
  numbered: Tag.define(),
  name: Tag.define(),
};

/** Classes are used so that the colours follow the theme (code.css). */
export const highlightStyle = HighlightStyle.define([
  ...Object.entries(tokenTable).map(([name, tag]) => ({ tag, class: `word-${name}` })),
  { tag: tags.comment, class: "word-comment" },
  { tag: [tags.keyword, tags.controlKeyword, tags.operatorKeyword], class: "word-keyword" },
  { tag: [tags.number, tags.bool, tags.atom], class: "word-number" },
  { tag: tags.string, class: "word-string" },
]);

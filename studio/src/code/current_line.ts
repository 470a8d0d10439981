// Mark of the line that the machine is executing.

import { RangeSetBuilder, StateEffect, StateField, type EditorState, type Text } from "@codemirror/state";
import { Decoration, EditorView, GutterMarker, gutterLineClass, type DecorationSet } from "@codemirror/view";

/** Line in progress, counted from 1; 0: none. */
export const setCurrentLine = StateEffect.define<number>();

const mark = Decoration.line({ class: "cm-runningLine" });

class RunningMarker extends GutterMarker {
  override elementClass = "cm-runningGutter";
}
const gutterMark = new RunningMarker();

/** Start of the marked line; it moves with edits above it. */
const field = StateField.define<number>({
  create: () => -1,
  update(position, { effects, changes, newDoc }) {
    let at = position < 0 ? -1 : changes.mapPos(position);
    for (const effect of effects) if (effect.is(setCurrentLine)) at = lineStartPosition(newDoc, effect.value);
    return at;
  },
  provide: (own) => [
    EditorView.decorations.compute([own, "doc"], (state): DecorationSet => {
      const at = currentLineStart(state);
      return at < 0 ? Decoration.none : Decoration.set(mark.range(at));
    }),
    gutterLineClass.compute([own, "doc"], (state) => {
      const marks = new RangeSetBuilder<GutterMarker>();
      const at = currentLineStart(state);
      if (at >= 0) marks.add(at, at, gutterMark);
      return marks.finish();
    }),
  ],
});

const lineStartPosition = (doc: Text, line: number): number => (line >= 1 && line <= doc.lines ? doc.line(line).from : -1);

// An edit may have joined the line to the one above.
function currentLineStart(state: EditorState): number {
  const at = state.field(field);
  return at < 0 ? -1 : state.doc.lineAt(Math.min(at, state.doc.length)).from;
}

export const currentLine = field;

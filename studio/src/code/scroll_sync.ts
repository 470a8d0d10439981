// Two editors with adjacent lines that scroll together. All lines have the same height, and the Lua has one
// more.

import type { Editor } from "./editor";
import { OFFSET_LINES } from "./translation_pane";

/**
 * Synchronises the scrolling. The editor that the user touched last is the master, so that neither reacts to
 * the other's scrolling. Returns a function that scrolls the translation to the source's position.
 */
export function synchroniseScrolling(source: Editor, translation: Editor, isSplit: () => boolean): () => void {
  let leader = source;
  const offset_px = () => OFFSET_LINES * translation.view.defaultLineHeight;
  const follow = (from: Editor, to: Editor, sign: number) => {
    if (leader !== from || !isSplit()) return;
    const top = from.view.scrollDOM.scrollTop + sign * offset_px();
    if (Math.abs(to.view.scrollDOM.scrollTop - top) >= 1) to.view.scrollDOM.scrollTop = top;
  };
  const lead = (editor: Editor, other: Editor, sign: number) => {
    const { scrollDOM, dom } = editor.view;
    for (const kind of ["wheel", "pointerdown", "touchstart", "focusin"]) {
      dom.addEventListener(kind, () => (leader = editor), { passive: true });
    }
    scrollDOM.addEventListener("scroll", () => follow(editor, other, sign), { passive: true });
  };
  lead(source, translation, 1);
  lead(translation, source, -1);
  return () => {
    leader = source;
    follow(source, translation, 1);
  };
}

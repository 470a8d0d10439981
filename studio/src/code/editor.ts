// CodeMirror editor with the features that G-code and Lua have in common.

import { closeBrackets, closeBracketsKeymap } from "@codemirror/autocomplete";
import { defaultKeymap, history, historyKeymap } from "@codemirror/commands";
import { bracketMatching } from "@codemirror/language";
import { lintGutter, lintKeymap } from "@codemirror/lint";
import { gotoLine, highlightSelectionMatches, search, searchKeymap } from "@codemirror/search";
import { Annotation, Compartment, EditorState, type Extension } from "@codemirror/state";
import {
  EditorView,
  drawSelection,
  highlightActiveLine,
  highlightActiveLineGutter,
  highlightSpecialChars,
  keymap,
  lineNumbers,
  placeholder,
  type ViewUpdate,
} from "@codemirror/view";
import { appearance } from "./appearance";
import { currentLine, setCurrentLine } from "./current_line";
import { heatGutter } from "./heat";

/** Mark of editor changes by this part of the page, to distinguish them from the user's. */
export const programmaticEdit = Annotation.define<boolean>();

export interface EditorEvents {
  onUpdate(update: ViewUpdate): void;
  /** Handles a click next to a line. */
  onGutterClick(line: number): void;
  run(): void;
  leave(): void;
}

/** Settings that may change while the text stays. */
export interface Configuration {
  language: Extension;
  readOnly: boolean;
  /** Label for screen readers. */
  label: string;
  /** Text shown in an empty editor. */
  hint: string;
}

export class Editor {
  readonly view: EditorView;
  private readonly configurationCompartment = new Compartment();
  private lastInput_ms = -Infinity;

  constructor(
    host: HTMLElement,
    private readonly events: EditorEvents,
  ) {
    this.view = new EditorView({ parent: host });
    for (const kind of ["wheel", "touchmove", "pointerdown", "keydown"]) {
      const noted = () => (this.lastInput_ms = performance.now());
      this.view.scrollDOM.addEventListener(kind, noted, { passive: true });
    }
  }

  /** Creates a separate state for a text; show() displays it. */
  stateOf(text: string, configuration: Configuration): EditorState {
    return EditorState.create({
      doc: text,
      extensions: [this.configurationCompartment.of(this.extensions(configuration)), this.fixed(text.length < 4_000_000)],
    });
  }

  /** Configures the displayed text. */
  configure(configuration: Configuration): void {
    const changed = this.configurationCompartment.reconfigure(this.extensions(configuration));
    this.view.dispatch({ effects: changed, annotations: programmaticEdit.of(true) });
  }

  show(state: EditorState): void {
    this.view.setState(state);
  }

  /** Returns the seconds since the user scrolled, pressed or typed here. */
  get untouched_s(): number {
    return (performance.now() - this.lastInput_ms) / 1000;
  }

  /** Marks the line that the machine is executing; 0: none. */
  mark(line: number): void {
    this.view.dispatch({ effects: setCurrentLine.of(line), annotations: programmaticEdit.of(true) });
  }

  /** Moves the cursor to a line. */
  select(line: number): void {
    const { doc } = this.view.state;
    if (line < 1 || line > doc.lines) return;
    this.view.dispatch({ selection: { anchor: doc.line(line).from }, annotations: programmaticEdit.of(true) });
  }

  /**
   * Scrolls if the line is out of sight or near the edge; a short distance smoothly. `height_px`: the visible
   * height, if it is less than the editor's height.
   */
  reveal(line: number, height_px = Infinity): void {
    const { doc } = this.view.state;
    if (line < 1 || line > doc.lines) return;
    const { scrollDOM } = this.view;
    const height = Math.min(scrollDOM.clientHeight, height_px);
    if (height === 0) return;
    const block = this.view.lineBlockAt(doc.line(line).from);
    const top = block.top + this.view.documentPadding.top - scrollDOM.scrollTop;
    const margin = Math.min(3 * block.height, height / 4);
    if (top >= margin && top + block.height <= height - margin) return;
    const still = matchMedia("(prefers-reduced-motion: reduce)").matches;
    const near = top > -height && top < 2 * height && !still;
    scrollDOM.scrollTo({ top: scrollDOM.scrollTop + top - height / 3, behavior: near ? "smooth" : "instant" });
  }

  private extensions({ language, readOnly, label, hint }: Configuration): Extension {
    return [
      language,
      EditorState.readOnly.of(readOnly),
      placeholder(hint),
      EditorView.contentAttributes.of({ "aria-label": label, ...(readOnly ? { "aria-readonly": "true" } : {}) }),
    ];
  }

  private fixed(short: boolean): Extension {
    return [
      lintGutter(),
      lineNumbers({
        domEventHandlers: {
          click: (view, block) => {
            this.events.onGutterClick(view.state.doc.lineAt(block.from).number);
            return true;
          },
        },
      }),
      heatGutter,
      currentLine,
      highlightSpecialChars(),
      history(),
      drawSelection(),
      highlightActiveLine(),
      highlightActiveLineGutter(),
      short ? [bracketMatching(), highlightSelectionMatches()] : [],
      closeBrackets(),
      search({ top: true }),
      appearance,
      this.keys(),
      EditorView.updateListener.of((update) => this.events.onUpdate(update)),
    ];
  }

  private keys(): Extension {
    const run = () => (this.events.run(), true);
    const leave = () => (this.events.leave(), true);
    return keymap.of([
      { key: "Mod-Enter", run, preventDefault: true },
      { key: "Mod-g", run: gotoLine, preventDefault: true },
      ...closeBracketsKeymap,
      ...searchKeymap,
      ...historyKeymap,
      ...lintKeymap,
      ...defaultKeymap.filter(({ key }) => key !== "Mod-Enter"),
      { key: "Escape", run: leave },
    ]);
  }
}

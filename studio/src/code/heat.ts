// Slim column next to the lines: the time of each, as a share of the slowest.

import { StateEffect, StateField, type Extension } from "@codemirror/state";
import { GutterMarker, gutter } from "@codemirror/view";
import { element } from "../core/dom";

/** Time of each line in seconds as a share of the slowest line's, with a text; null: it has not run. */
export interface LineHeat {
  of(line: number): { share: number; text: string } | null;
}

/** Replaces the times by those of another run. */
export const setHeat = StateEffect.define<LineHeat | null>();

const heatField = StateField.define<LineHeat | null>({
  create: () => null,
  update(heat, { effects }) {
    for (const effect of effects) if (effect.is(setHeat)) heat = effect.value;
    return heat;
  },
});

const WIDTH_PX = 10;

class HeatMarker extends GutterMarker {
  constructor(
    private readonly share: number,
    private readonly text: string,
  ) {
    super();
  }

  override eq(other: HeatMarker): boolean {
    return other.share === this.share && other.text === this.text;
  }

  override toDOM(): Node {
    const bar = element("div", { class: "cm-heat", title: this.text });
    bar.style.setProperty("--share", String(this.share));
    bar.style.width = `${Math.max(1, Math.round(this.share * WIDTH_PX))}px`;
    return bar;
  }
}

export const heatGutter: Extension = [
  heatField,
  gutter({
    class: "cm-heatGutter",
    lineMarker(view, block) {
      const heat = view.state.field(heatField);
      const found = heat?.of(view.state.doc.lineAt(block.from).number);
      return found ? new HeatMarker(found.share, found.text) : null;
    },
    lineMarkerChange: (update) => update.startState.field(heatField) !== update.state.field(heatField),
    initialSpacer: () => new HeatMarker(1, ""),
  }),
];

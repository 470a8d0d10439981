// Work frame of a path, or of its use: the work offset, and the position that the program itself sets for it.

import { element } from "../../core/dom";
import type { Units } from "../../core/store";
import type { FrameChange } from "../../run/path/path_edit";
import type { WorkFrame } from "../../run/path/path_file";
import type { Vector } from "../../run/path/vector";
import { texts } from "../../texts";
import { ChoiceRow, NumbersRow, TextRow } from "./fields";

const words = texts.paths.form;
const own = texts.paths.frame;
type Origin = keyof typeof own.origins;

interface FrameState {
  frame: WorkFrame;
  /** Frame that applies if the path sets none, in words. */
  inherited: string;
  units: Units;
}

export class FrameFields {
  readonly element: HTMLElement;
  private at: FrameState | null = null;
  private readonly offset = new TextRow(words.workOffset, (name) => this.setOffset(name.trim()));
  private readonly origin = new ChoiceRow<Origin>(own.origin, [["control", own.origins.control], ["program", own.origins.program]], (origin) =>
    this.change({ set_offset_mm: origin === "program" ? [0, 0, 0] : undefined }),
  );
  private readonly place = new NumbersRow(own.place, ["X", "Y", "Z"], "length", (values) => this.setOffsetPosition(values));
  private readonly note = element("p", { class: "note" });

  constructor(private readonly change: (change: FrameChange) => void) {
    const rows = [this.offset, this.origin, this.place].map((row) => row.element);
    this.element = element("div", { class: "group" }, ...rows, this.note);
  }

  show(displayed: FrameState): void {
    this.at = displayed;
    const { frame, inherited, units } = displayed;
    const { work_offset, set_offset_mm, probe_offset } = frame;
    this.offset.show(work_offset ?? "", inherited);
    this.origin.element.hidden = work_offset === undefined;
    this.origin.show(set_offset_mm ? "program" : "control");
    this.place.element.hidden = set_offset_mm === undefined;
    this.place.show(set_offset_mm ?? [], units);
    this.note.hidden = probe_offset === undefined;
    this.note.textContent = own.touches(probe_offset?.length ?? 0);
  }

  /** Without a work offset no position can be set. */
  private setOffset(name: string): void {
    this.change(name === "" ? { work_offset: undefined, set_offset_mm: undefined } : { work_offset: name });
  }

  /** An emptied field keeps its value. */
  private setOffsetPosition(values: (number | undefined)[]): void {
    const before = this.at?.frame.set_offset_mm;
    if (!this.at || !before) return;
    if (values.includes(undefined)) return this.show(this.at);
    this.change({ set_offset_mm: values as Vector });
  }
}

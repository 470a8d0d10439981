// Settings of a path for its position and tools: its work frame and its tool.

import { element } from "../../core/dom";
import type { Units } from "../../core/store";
import type { SetUpChange } from "../../run/path/path_edit";
import { isRecorded, rootIndex, type PathFile } from "../../run/path/path_file";
import { setUpKeys } from "../../run/path/target_checks";
import { texts } from "../../texts";
import { NumberRow } from "./fields";
import { FrameFields } from "./frame_fields";

const words = texts.paths.frame;

/**
 * True if fields for frames and tools are useful: a recorded path takes none, but existing ones can be
 * removed.
 */
export const acceptsSetup = (file: PathFile, of: object): boolean => !isRecorded(file) || setUpKeys.some((key) => key in of);

export class SetUpFields {
  readonly element: HTMLElement;
  private readonly frame: FrameFields;
  private readonly tool: NumberRow;
  private readonly length: NumberRow;
  private readonly diameter: NumberRow;
  private readonly fields: HTMLElement;
  private readonly recorded = element("p", { class: "note" }, words.recorded);

  constructor(change: (change: SetUpChange) => void) {
    this.frame = new FrameFields(change);
    // Offsets are removed with the tool.
    this.tool = new NumberRow(words.tool, "none", (tool) =>
      change(tool === undefined ? { tool, length_offset: undefined, diameter_offset: undefined } : { tool }),
    );
    this.length = new NumberRow(words.lengthOffset, "none", (length_offset) => change({ length_offset }));
    this.diameter = new NumberRow(words.diameterOffset, "none", (diameter_offset) => change({ diameter_offset }));
    const rows = [this.frame, this.tool, this.length, this.diameter].map((row) => row.element);
    this.fields = element("div", { class: "group" }, ...rows);
    this.element = element("div", { class: "group" }, this.fields, this.recorded);
  }

  show(file: PathFile, path: number, units: Units): void {
    const own = file.paths[path];
    this.fields.hidden = !acceptsSetup(file, own);
    this.recorded.hidden = !isRecorded(file);
    this.frame.show({ frame: own, inherited: rootIndex(file) === path ? words.ofPost : words.ofUser, units });
    this.tool.show({ value: own.tool }, units);
    this.length.element.hidden = this.diameter.element.hidden = own.tool === undefined;
    // The length offset of a tool has the number of the tool, unless another one is given.
    this.length.show({ value: own.length_offset, inherited: own.tool }, units);
    this.diameter.show({ value: own.diameter_offset }, units);
  }
}

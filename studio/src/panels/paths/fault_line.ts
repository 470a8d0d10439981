// Error at a position of a path, above its form.

import { element } from "../../core/dom";
import type { PathShown } from "../../core/path_shown";
import { isSamePlace, type Place } from "../../run/path/path_file";

export class FaultLine {
  readonly element = element("p", { class: "fault", role: "alert" });

  show({ walk }: PathShown, place: Place): void {
    this.element.textContent = walk.faults.find((fault) => isSamePlace(fault.place, place))?.text ?? "";
    this.element.hidden = this.element.textContent === "";
  }
}

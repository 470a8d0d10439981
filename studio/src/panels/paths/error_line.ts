// Error at a position of a path, above its form.

import { element } from "../../core/dom";
import type { DisplayedPath } from "../../core/displayed_path";
import { isSameTarget, type TargetId } from "../../run/path/path_file";

export class ErrorLine {
  readonly element = element("p", { class: "fault", role: "alert" });

  show({ walk }: DisplayedPath, place: TargetId): void {
    this.element.textContent = walk.errors.find((error) => isSameTarget(error.place, place))?.text ?? "";
    this.element.hidden = this.element.textContent === "";
  }
}

// Mark as text in the strip: position, kind and message.

import { markText } from "../core/display_names";
import type { Units } from "../core/store";
import type { Mark } from "../run/marks";
import { texts } from "../texts";

/** Returns "line 14: jet on", "line 12: Collision: nozzle – clamp" */
export function fullMarkText(mark: Mark, units: Units): string {
  const said = markText(mark, units);
  const what = mark.kind === "event" ? said : `${texts.time.marks[mark.kind]}: ${said}`;
  return mark.line === null ? what : `${texts.run.line(mark.line)}: ${what}`;
}

// A mark as people read it.

import type { Units } from "../core/store";
import { lengthText } from "../core/units";
import type { Mark } from "../run/marks";
import { texts } from "../texts";

/** "line 14: jet on" */
export function markText(mark: Mark, units: Units): string {
  const what = whatOf(mark, units);
  return mark.line === null ? what : texts.time.atLine(mark.line, what);
}

function whatOf({ kind, text, detail, pair, clearance_mm }: Mark, units: Units): string {
  const words = texts.time.marks;
  if (kind === "event") return `${text.replaceAll("_", " ")} ${detail}`.trim();
  if (kind === "collision") return `${words.collision}: ${pair!.join(" – ")}`;
  if (kind === "near") return `${words.near}: ${pair!.join(" – ")}, ${lengthText(clearance_mm, units)}`;
  return `${words[kind]}: ${text}`;
}

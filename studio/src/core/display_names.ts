// Displayed names of limits and marks of a run.

import type { NamedLimit } from "../run/limits";
import type { Mark } from "../run/marks";
import { texts } from "../texts";
import type { Units } from "./store";
import { lengthText } from "./units";

const words = texts.run;

/** "acceleration of Y" */
export function limitText({ kind, letter }: NamedLimit): string {
  if (kind === "joint_speed" && letter) return words.speedOf(letter);
  if (kind === "acceleration" && letter) return words.accelerationOf(letter);
  return words.limits[kind];
}

const pairText = (pair: readonly [string, string]): string => pair.join(" – ");

/** Returns an event's kind: "jet on". */
export const eventText = (kind: string): string => kind.replaceAll("_", " ");

/** Returns the text of a mark, without its kind. */
export function markText({ kind, text, detail, pair, clearance_mm }: Mark, units: Units): string {
  if (kind === "event") return `${eventText(text)} ${detail}`.trim();
  if (kind === "near" && pair) return `${pairText(pair)}: ${lengthText(clearance_mm, units)}`;
  return pair ? pairText(pair) : text;
}

// What keeps values from being a target of a path: a point, or another path.

import type { JsonValue } from "../../core/json_text";
import { texts } from "../../texts";

/** What a value must be, in words; null: it is so. */
type Check = (value: JsonValue) => string | null;

const words = texts.paths.faults;

const GREATEST = 1e6; // mm or deg; beyond any machine
const GREATEST_RATE = 1e9;
const MOST_REPEATS = 1e9;
const MOST_TURN_DEG = 360_000;

const isNumber = (value: JsonValue): value is number => typeof value === "number";
const isVector = (value: JsonValue): value is number[] => Array.isArray(value) && value.length === 3 && value.every(isNumber);

const isText: Check = (value) => (typeof value === "string" && value !== "" ? null : words.text);
const isName: Check = (value) => (typeof value === "string" ? null : words.string);
const isRate: Check = (value) =>
  isNumber(value) && value > 0 && value <= GREATEST_RATE ? null : words.rate;
const isMotion: Check = (value) =>
  ["rapid", "linear", "circular", "none"].includes(value as string) ? null : words.motion;
const isPlace: Check = (value) =>
  isVector(value) && value.every((each) => Math.abs(each) <= GREATEST) ? null : words.vector;
const isDirection: Check = (value) => isPlace(value) ?? (Math.hypot(...(value as number[])) > 1e-9 ? null : words.direction);
const isTurn: Check = (value) =>
  isNumber(value) && value > 0 && value <= MOST_TURN_DEG ? null : words.turn;
const isDwell: Check = (value) =>
  isNumber(value) && value >= 0 && value <= GREATEST ? null : words.dwell;
const isRepeats: Check = (value) =>
  isNumber(value) && Number.isInteger(value) && value >= 1 && value <= MOST_REPEATS ? null : words.repeats;

function areAxes(value: JsonValue): string | null {
  const isOne = ([letter, angle]: [string, JsonValue | undefined]) =>
    /^[A-Z]$/.test(letter) && typeof angle === "number" && Math.abs(angle) <= GREATEST;
  const areAll = typeof value === "object" && value !== null && !Array.isArray(value) && Object.entries(value).every(isOne);
  return areAll ? null : words.axes;
}

const areActions: Check = (value) =>
  Array.isArray(value) && value.every((each) => typeof each === "string" && each !== "") ? null : words.actions;

const pointChecks: Record<string, Check> = {
  name: isName,
  motion: isMotion,
  position_mm: isPlace,
  via_mm: isPlace,
  center_mm: isPlace,
  normal: isDirection,
  turn_deg: isTurn,
  tool_axis: isDirection,
  rpy_deg: isPlace,
  rotary_deg: areAxes,
  feed_mm_min: isRate,
  feed_deg_min: isRate,
  duration_s: isRate,
  feed_mm_rev: isRate,
  lead_mm: isRate,
  work_offset: isText,
  acceleration_mm_s2: isRate,
  dwell_s: isDwell,
  actions: areActions,
};
const subPathChecks: Record<string, Check> = { path: isText, repeats: isRepeats };

/** Keys of a point, in the order in which files have them. */
export const pointKeys: readonly string[] = Object.keys(pointChecks);

type Members = { [key: string]: JsonValue | undefined };

function faultOfValues(target: Members, checks: Record<string, Check>, what: string): string | null {
  for (const [key, value] of Object.entries(target)) {
    if (!Object.hasOwn(checks, key)) return words.unknownKey(key, what, Object.keys(checks).join(", "));
    const fault = value === undefined ? null : checks[key](value);
    if (fault) return words.value(key, fault);
  }
  return null;
}

function faultOfArc(point: Members): string | null {
  const has = (key: string) => point[key] !== undefined;
  if (point.motion !== "circular") {
    const key = ["via_mm", "center_mm", "normal", "turn_deg"].find(has);
    return key ? words.circularOnly(key) : null;
  }
  if (has("via_mm") === has("center_mm")) return words.viaOrCenter;
  if (has("center_mm") && !has("turn_deg")) return words.noTurn;
  if (has("via_mm") && (has("normal") || has("turn_deg"))) {
    return words.viaAlone;
  }
  return null;
}

function faultOfPoint(point: Members): string | null {
  const has = (key: string) => point[key] !== undefined;
  if (!has("position_mm")) return words.noPosition;
  if (["tool_axis", "rpy_deg", "rotary_deg"].filter(has).length > 1) {
    return words.oneOrientation;
  }
  if (has("feed_mm_rev") && !has("feed_mm_min")) return words.feedOfTurns;
  if (has("lead_mm") && (point.motion ?? "linear") !== "linear") return words.leadLinear;
  return faultOfArc(point);
}

/** A sentence; null: nothing does. */
export function faultOfTarget(target: JsonValue): string | null {
  if (typeof target !== "object" || target === null || Array.isArray(target)) {
    return words.noTarget;
  }
  if ("path" in target) return faultOfValues(target, subPathChecks, words.ofSubPath);
  return faultOfValues(target, pointChecks, words.ofPoint) ?? faultOfPoint(target);
}

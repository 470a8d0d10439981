// Errors that keep values from being a target of a path: a point, or another path.

import type { JsonValue } from "../../core/json_text";
import { texts } from "../../texts";

/** Returns the required form of a value, in words, or null if it is valid. */
type Check = (value: JsonValue) => string | null;

const words = texts.paths.faults;

const GREATEST = 1e6; // mm or deg; beyond any machine
const GREATEST_RATE = 1e9;
const MOST_REPEATS = 1e9;
const MOST_TURN_DEG = 360_000;
const REFERENCES = 4;
const MOST_FIXED = 99_999;
const MOST_TOOLS = 99_999_999;

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

const isWhole = (value: JsonValue, least: number, most: number): boolean =>
  isNumber(value) && Number.isInteger(value) && value >= least && value <= most;
const isPointName = (value: JsonValue): boolean => typeof value === "string" && /^[A-Za-z][A-Za-z0-9_]{0,255}$/.test(value);
const isReference: Check = (value) => (isWhole(value, 1, REFERENCES) || isPointName(value) ? null : words.reference);
const isFixedPoint: Check = (value) => (isWhole(value, 1, MOST_FIXED) || isPointName(value) ? null : words.fixed);
const isToolNumber: Check = (value) => (isWhole(value, 0, MOST_TOOLS) ? null : words.tool);

const isAxis: Check = (value) => (["X", "Y", "Z"].includes(value as string) ? null : words.axis);
const isLength: Check = (value) => (isNumber(value) && Math.abs(value) <= GREATEST ? null : words.length);
const isRadius: Check = (value) => (isNumber(value) && value >= 0 && value <= GREATEST ? null : words.radius);

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
const touchChecks: Record<string, Check> = {
  axis: isAxis,
  from_mm: isPlace,
  to_mm: isLength,
  surface_mm: isLength,
  feed_mm_min: isRate,
  probe_radius_mm: isRadius,
  tool: isToolNumber,
};
const NEEDED_OF_TOUCH = 5;

function areTouches(value: JsonValue): string | null {
  if (!Array.isArray(value) || value.length === 0) return words.touches;
  for (const touch of value) {
    if (typeof touch !== "object" || touch === null || Array.isArray(touch)) return words.touches;
    const lacked = Object.keys(touchChecks).slice(0, NEEDED_OF_TOUCH).find((key) => touch[key] === undefined);
    if (lacked) return words.touchLacks(lacked);
    const fault = faultOfValues(touch, touchChecks, words.ofTouch);
    if (fault) return words.inTouch(fault);
  }
  return null;
}

const frameChecks: Record<string, Check> = { work_offset: isText, set_offset_mm: isPlace, probe_offset: areTouches };
const subPathChecks: Record<string, Check> = { path: isText, repeats: isRepeats, ...frameChecks };
const machinePointChecks: Record<string, Check> = {
  name: isName,
  fixed: isFixedPoint,
  reference: isReference,
  dwell_s: isDwell,
  actions: areActions,
};
const setUpChecks: Record<string, Check> = {
  ...frameChecks,
  tool: isToolNumber,
  length_offset: isToolNumber,
  diameter_offset: isToolNumber,
};

/** Keys of the use of a path, in the order of files. */
export const subPathKeys: readonly string[] = Object.keys(subPathChecks);

/** Keys of a fixed or reference point, in the order of files. */
export const machinePointKeys: readonly string[] = Object.keys(machinePointChecks);

/** Keys of a path that set its position and tool. */
export const setUpKeys: readonly string[] = Object.keys(setUpChecks);

/** Keys of a point, in the order of files. */
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

function faultOfFrame(of: Members): string | null {
  const lone = ["set_offset_mm", "probe_offset"].find((key) => of[key] !== undefined && of.work_offset === undefined);
  return lone ? words.goesWith(lone, "work_offset") : null;
}

/** Returns the error of the work frame and the tool of a path; other keys are ignored. */
export function faultOfSetUp(path: Members): string | null {
  const own = Object.fromEntries(Object.entries(path).filter(([key]) => setUpKeys.includes(key)));
  const lone = ["length_offset", "diameter_offset"].find((key) => path[key] !== undefined && path.tool === undefined);
  if (lone) return words.goesWith(lone, "tool");
  return faultOfValues(own, setUpChecks, words.ofPath) ?? faultOfFrame(path);
}

/** Returns a message, or null if the target is valid. */
export function faultOfTarget(target: JsonValue): string | null {
  if (typeof target !== "object" || target === null || Array.isArray(target)) {
    return words.noTarget;
  }
  if ("path" in target) return faultOfValues(target, subPathChecks, words.ofSubPath) ?? faultOfFrame(target);
  if ("fixed" in target && "reference" in target) return words.fixedOrReference;
  if ("fixed" in target || "reference" in target) return faultOfValues(target, machinePointChecks, words.ofMachinePoint);
  return faultOfValues(target, pointChecks, words.ofPoint) ?? faultOfPoint(target);
}

// Errors that keep values from being a target of a path: a point, or another path.

import type { JsonValue } from "../../core/json_text";
import { texts } from "../../texts";

/** Returns the required form of a value, in words, or null if it is valid. */
type Check = (value: JsonValue) => string | null;

const words = texts.paths.errors;

const MAX_COORDINATE = 1e6; // mm or deg; beyond any machine
const MAX_RATE = 1e9;
const MAX_REPEATS = 1e9;
const MAX_TURN_DEG = 360_000;
const MAX_REFERENCE_POINT = 4;
const MAX_FIXED_POINT = 99_999;
const MAX_TOOL_NUMBER = 99_999_999;

const isNumber = (value: JsonValue): value is number => typeof value === "number";
const isVector = (value: JsonValue): value is number[] => Array.isArray(value) && value.length === 3 && value.every(isNumber);

const isText: Check = (value) => (typeof value === "string" && value !== "" ? null : words.text);
const isName: Check = (value) => (typeof value === "string" ? null : words.string);
const isRate: Check = (value) =>
  isNumber(value) && value > 0 && value <= MAX_RATE ? null : words.rate;
const isMotion: Check = (value) =>
  ["rapid", "linear", "circular", "none"].includes(value as string) ? null : words.motion;
const isPosition: Check = (value) =>
  isVector(value) && value.every((each) => Math.abs(each) <= MAX_COORDINATE) ? null : words.vector;
const isDirection: Check = (value) => isPosition(value) ?? (Math.hypot(...(value as number[])) > 1e-9 ? null : words.direction);
const isTurn: Check = (value) =>
  isNumber(value) && value > 0 && value <= MAX_TURN_DEG ? null : words.turn;
const isDwell: Check = (value) =>
  isNumber(value) && value >= 0 && value <= MAX_COORDINATE ? null : words.dwell;
const isRepeats: Check = (value) =>
  isNumber(value) && Number.isInteger(value) && value >= 1 && value <= MAX_REPEATS ? null : words.repeats;

const isInRange = (value: JsonValue, least: number, most: number): boolean =>
  isNumber(value) && Number.isInteger(value) && value >= least && value <= most;
const isPointName = (value: JsonValue): boolean => typeof value === "string" && /^[A-Za-z][A-Za-z0-9_]{0,255}$/.test(value);
const isReference: Check = (value) => (isInRange(value, 1, MAX_REFERENCE_POINT) || isPointName(value) ? null : words.reference);
const isFixedPoint: Check = (value) => (isInRange(value, 1, MAX_FIXED_POINT) || isPointName(value) ? null : words.fixed);
const isToolNumber: Check = (value) => (isInRange(value, 0, MAX_TOOL_NUMBER) ? null : words.tool);

const isAxis: Check = (value) => (["X", "Y", "Z"].includes(value as string) ? null : words.axis);
const isLength: Check = (value) => (isNumber(value) && Math.abs(value) <= MAX_COORDINATE ? null : words.length);
const isRadius: Check = (value) => (isNumber(value) && value >= 0 && value <= MAX_COORDINATE ? null : words.radius);

function areAxes(value: JsonValue): string | null {
  const isOne = ([letter, angle]: [string, JsonValue | undefined]) =>
    /^[A-Z]$/.test(letter) && typeof angle === "number" && Math.abs(angle) <= MAX_COORDINATE;
  const areValid = typeof value === "object" && value !== null && !Array.isArray(value) && Object.entries(value).every(isOne);
  return areValid ? null : words.axes;
}

const areActions: Check = (value) =>
  Array.isArray(value) && value.every((each) => typeof each === "string" && each !== "") ? null : words.actions;

const pointChecks: Record<string, Check> = {
  name: isName,
  motion: isMotion,
  position_mm: isPosition,
  via_mm: isPosition,
  center_mm: isPosition,
  normal: isDirection,
  turn_deg: isTurn,
  tool_axis: isDirection,
  rpy_deg: isPosition,
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
  from_mm: isPosition,
  to_mm: isLength,
  surface_mm: isLength,
  feed_mm_min: isRate,
  probe_radius_mm: isRadius,
  tool: isToolNumber,
};
const REQUIRED_TOUCH_KEYS = 5;

function areTouches(value: JsonValue): string | null {
  if (!Array.isArray(value) || value.length === 0) return words.touches;
  for (const touch of value) {
    if (typeof touch !== "object" || touch === null || Array.isArray(touch)) return words.touches;
    const missingKey = Object.keys(touchChecks).slice(0, REQUIRED_TOUCH_KEYS).find((key) => touch[key] === undefined);
    if (missingKey) return words.touchLacks(missingKey);
    const error = valuesError(touch, touchChecks, words.ofTouch);
    if (error) return words.inTouch(error);
  }
  return null;
}

const frameChecks: Record<string, Check> = { work_offset: isText, set_offset_mm: isPosition, probe_offset: areTouches };
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

function valuesError(target: Members, checks: Record<string, Check>, what: string): string | null {
  for (const [key, value] of Object.entries(target)) {
    if (!Object.hasOwn(checks, key)) return words.unknownKey(key, what, Object.keys(checks).join(", "));
    const error = value === undefined ? null : checks[key](value);
    if (error) return words.value(key, error);
  }
  return null;
}

function arcError(point: Members): string | null {
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

function pointError(point: Members): string | null {
  const has = (key: string) => point[key] !== undefined;
  if (!has("position_mm")) return words.noPosition;
  if (["tool_axis", "rpy_deg", "rotary_deg"].filter(has).length > 1) {
    return words.oneOrientation;
  }
  if (has("feed_mm_rev") && !has("feed_mm_min")) return words.feedOfTurns;
  if (has("lead_mm") && (point.motion ?? "linear") !== "linear") return words.leadLinear;
  return arcError(point);
}

function frameError(of: Members): string | null {
  const unusedOffset = ["set_offset_mm", "probe_offset"].find((key) => of[key] !== undefined && of.work_offset === undefined);
  return unusedOffset ? words.goesWith(unusedOffset, "work_offset") : null;
}

/** Returns the error of the work frame and the tool of a path; other keys are ignored. */
export function setupValuesError(path: Members): string | null {
  const own = Object.fromEntries(Object.entries(path).filter(([key]) => setUpKeys.includes(key)));
  const unusedOffset = ["length_offset", "diameter_offset"].find((key) => path[key] !== undefined && path.tool === undefined);
  if (unusedOffset) return words.goesWith(unusedOffset, "tool");
  return valuesError(own, setUpChecks, words.ofPath) ?? frameError(path);
}

/** Returns a message, or null if the target is valid. */
export function targetError(target: JsonValue): string | null {
  if (typeof target !== "object" || target === null || Array.isArray(target)) {
    return words.noTarget;
  }
  if ("path" in target) return valuesError(target, subPathChecks, words.ofSubPath) ?? frameError(target);
  if ("fixed" in target && "reference" in target) return words.fixedOrReference;
  if ("fixed" in target || "reference" in target) return valuesError(target, machinePointChecks, words.ofMachinePoint);
  return valuesError(target, pointChecks, words.ofPoint) ?? pointError(target);
}

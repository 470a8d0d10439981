// Path file (docs/paths.md) in the page: paths of points and sub-paths, and errors of its text.

import { formatError } from "../../core/file_format";
import { JsonError, readJson, valueSpan, type JsonPath, type JsonValue } from "../../core/json_text";
import { texts } from "../../texts";
import { setupValuesError, targetError, setUpKeys } from "./target_checks";
import type { Vector } from "./vector";

export const motionTypes = ["rapid", "linear", "circular", "none"] as const;
export type MotionType = (typeof motionTypes)[number];

/** Possible members of a point, in the order of the file. */
export interface Point {
  name?: string;
  /** Without it: linear. */
  motion?: MotionType;
  position_mm: Vector;
  via_mm?: Vector;
  center_mm?: Vector;
  normal?: Vector;
  turn_deg?: number;
  tool_axis?: Vector;
  rpy_deg?: Vector;
  rotary_deg?: Record<string, number>;
  feed_mm_min?: number;
  feed_deg_min?: number;
  duration_s?: number;
  feed_mm_rev?: number;
  lead_mm?: number;
  work_offset?: string;
  acceleration_mm_s2?: number;
  dwell_s?: number;
  actions?: string[];
}

/** Work coordinate system of the positions of a path, or of a use of one. */
export interface WorkFrame {
  work_offset?: string;
  set_offset_mm?: Vector;
  probe_offset?: Touch[];
}

/**
 * Straight motion along an axis until the tool touches something, by which a program finds the position of a
 * work offset.
 */
export interface Touch {
  axis: "X" | "Y" | "Z";
  from_mm: Vector;
  to_mm: number;
  surface_mm: number;
  feed_mm_min: number;
  probe_radius_mm?: number;
  tool?: number;
}

export interface SubPath extends WorkFrame {
  path: string;
  repeats?: number;
}

/** Position of the machine that its controller, or its data, knows: its position in the work is unknown. */
export interface MachinePoint {
  name?: string;
  /** Fixed point of the machine data, by name or number. */
  fixed?: string | number;
  /** Home position of the controller, 1 to 4, or a reference point of the machine data, by name. */
  reference?: string | number;
  dwell_s?: number;
  actions?: string[];
}

export type Target = Point | SubPath | MachinePoint;

/** Position and tool of a path. */
export interface SetUp extends WorkFrame {
  tool?: number;
  /** Default: that of the tool. */
  length_offset?: number;
  diameter_offset?: number;
}

export interface Path extends SetUp {
  name: string;
  targets: Target[];
}

export interface PathFile {
  name?: string;
  root?: string;
  work_offsets?: Record<string, Record<string, number>>;
  paths: Path[];
}

/** Target of a path, both by number; a target of -1 is the path itself. */
export interface TargetId {
  path: number;
  target: number;
}

/** Error of a path file, and its position. */
export interface Error {
  text: string;
  /** null: with all of it. */
  place: TargetId | null;
}

export const isSubPath = (target: Target): target is SubPath => "path" in target;
export const isMachinePoint = (target: Target): target is MachinePoint => "fixed" in target || "reference" in target;
export const isPoint = (target: Target): target is Point => !isSubPath(target) && !isMachinePoint(target);
export const pointMotion = ({ motion }: Point): MotionType => motion ?? "linear";

export const targetKey = ({ path, target }: TargetId): string => `${path}/${target}`;
export const isSameTarget = (one: TargetId | null, other: TargetId | null): boolean =>
  one?.path === other?.path && one?.target === other?.target;

/** Returns the position of a place in the text. */
export const targetJsonPath = ({ path, target }: TargetId): JsonPath =>
  target < 0 ? ["paths", path] : ["paths", path, "targets", target];

export const targetAt = (file: PathFile, { path, target }: TargetId): Target | undefined => file.paths[path]?.targets[target];

export function pointAt(file: PathFile, place: TargetId): Point | undefined {
  const target = targetAt(file, place);
  return target && isPoint(target) ? target : undefined;
}

export const findPathIndex = (file: PathFile, name: string): number => file.paths.findIndex((path) => path.name === name);

/** Returns the number of the path to begin with; -1: no path has that name. */
export const rootIndex = (file: PathFile): number => (file.root === undefined ? 0 : findPathIndex(file, file.root));

/**
 * True if it was recorded from a run: its points set work offsets, their actions set tools, and it has no
 * machine points.
 */
export const isRecorded = ({ work_offsets }: PathFile): boolean => Object.keys(work_offsets ?? {}).length > 0;

const words = texts.paths.errors;

const FILE_KEYS = ["$schema", "format", "name", "root", "paths", "work_offsets"];
/** Keys of a path, in the order of files. */
export const pathKeys = ["name", ...setUpKeys, "targets"];

const isObject = (value: JsonValue | undefined): value is { [key: string]: JsonValue | undefined } =>
  typeof value === "object" && value !== null && !Array.isArray(value);

/** Returns a message about the first key that is not allowed there. */
const unknownKeyError = (value: object, known: string[], where: string): string | null => {
  const key = Object.keys(value).find((each) => !known.includes(each));
  return key === undefined ? null : words.unknownKey(key, where, known.join(", "));
};

/** Returns why JSON values are not a path file; the place is a position in the text. */
function structureError(value: JsonValue): { text: string; at: JsonPath } | null {
  if (!isObject(value)) return { text: words.noObject, at: [] };
  const unknown = unknownKeyError(value, FILE_KEYS, words.ofFile);
  if (unknown) return { text: unknown, at: [] };
  const otherFormat = formatError(value.format);
  if (otherFormat) return { text: otherFormat, at: ["format"] };
  for (const key of ["name", "root", "$schema"]) {
    if (value[key] !== undefined && typeof value[key] !== "string") return { text: words.noString(key), at: [key] };
  }
  const { paths } = value;
  if (!Array.isArray(paths) || paths.length === 0) return { text: words.noPaths, at: [] };
  for (let i = 0; i < paths.length; ++i) {
    const error = pathError(paths[i]);
    if (error) return { text: error.text, at: ["paths", i, ...error.at] };
  }
  return null;
}

function pathError(path: JsonValue): { text: string; at: JsonPath } | null {
  if (!isObject(path)) return { text: words.noPathObject, at: [] };
  const unknown = unknownKeyError(path, pathKeys, words.ofPath);
  if (unknown) return { text: unknown, at: [] };
  if (typeof path.name !== "string" || path.name === "") return { text: words.noName, at: [] };
  const setupError = setupValuesError(path);
  if (setupError) return { text: setupError, at: [] };
  const { targets } = path;
  if (!Array.isArray(targets) || targets.length === 0) return { text: words.noTargets(path.name), at: [] };
  for (let i = 0; i < targets.length; ++i) {
    const text = targetError(targets[i]);
    if (text) return { text, at: ["targets", i] };
  }
  return null;
}

/** With line and column. */
function errorAt(text: string, at: number, sentence: string): Error {
  const before = text.slice(0, at);
  return { text: words.at(before.split("\n").length, at - before.lastIndexOf("\n"), sentence), place: null };
}

/** Returns the path file, or the error of the text with line and column. */
export function readPathFile(text: string): PathFile | Error {
  try {
    const value = readJson(text);
    const error = structureError(value);
    if (!error) return value as unknown as PathFile;
    return errorAt(text, valueSpan(text, error.at).from, error.text);
  } catch (error) {
    if (!(error instanceof JsonError)) throw error;
    return errorAt(text, error.at, error.message);
  }
}

export const isPathFile = (read: PathFile | Error): read is PathFile => "paths" in read;

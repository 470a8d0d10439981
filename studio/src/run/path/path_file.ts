// A path file (docs/paths.md) as the page has it: paths of points and sub-paths, and what is wrong with its text.

import { JsonFault, readJson, spanOf, type JsonPlace, type JsonValue } from "../../core/json_text";
import { texts } from "../../texts";
import { faultOfSetUp, faultOfTarget, setUpKeys } from "./target_faults";
import type { Vector } from "./vector";

export const motionTypes = ["rapid", "linear", "circular", "none"] as const;
export type MotionType = (typeof motionTypes)[number];

/** What a point may have, in the order of the file. */
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

/** What a path, or the use of one, says of the work coordinate system that its positions are counted in. */
export interface WorkFrame {
  work_offset?: string;
  set_offset_mm?: Vector;
  probe_offset?: Touch[];
}

/** A straight way along an axis until the tool touches something, by which a program finds where a work offset lies. */
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

/** A place of the machine that its control, or its data, knows: where it is in the work nobody can tell. */
export interface MachinePoint {
  name?: string;
  /** A fixed point of the machine data, by its name or its number. */
  fixed?: string | number;
  /** A home position of the control, 1 to 4; a reference point of the machine data, by its name. */
  reference?: string | number;
  dwell_s?: number;
  actions?: string[];
}

export type Target = Point | SubPath | MachinePoint;

/** Where a path is, and with what it works. */
export interface SetUp extends WorkFrame {
  tool?: number;
  /** Without it: that of the tool. */
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

/** A target of a path, both by number; a target of -1 is the path itself. */
export interface Place {
  path: number;
  target: number;
}

/** What is wrong with a path file, and where. */
export interface Fault {
  text: string;
  /** null: with all of it. */
  place: Place | null;
}

export const isSubPath = (target: Target): target is SubPath => "path" in target;
export const isMachinePoint = (target: Target): target is MachinePoint => "fixed" in target || "reference" in target;
export const isPoint = (target: Target): target is Point => !isSubPath(target) && !isMachinePoint(target);
export const motionOf = ({ motion }: Point): MotionType => motion ?? "linear";

export const keyOfPlace = ({ path, target }: Place): string => `${path}/${target}`;
export const isSamePlace = (one: Place | null, other: Place | null): boolean =>
  one?.path === other?.path && one?.target === other?.target;

/** Where a place stands in the text. */
export const jsonPlaceOf = ({ path, target }: Place): JsonPlace =>
  target < 0 ? ["paths", path] : ["paths", path, "targets", target];

export const targetAt = (file: PathFile, { path, target }: Place): Target | undefined => file.paths[path]?.targets[target];

export function pointAt(file: PathFile, place: Place): Point | undefined {
  const target = targetAt(file, place);
  return target && isPoint(target) ? target : undefined;
}

export const indexOfPath = (file: PathFile, name: string): number => file.paths.findIndex((path) => path.name === name);

/** The number of the path to begin with; -1: there is none of that name. */
export const rootOf = (file: PathFile): number => (file.root === undefined ? 0 : indexOfPath(file, file.root));

/** Whether it was recorded from a run: its points say work offsets, their actions tools, and it has no machine points. */
export const isRecorded = ({ work_offsets }: PathFile): boolean => Object.keys(work_offsets ?? {}).length > 0;

const words = texts.paths.faults;

const FILE_KEYS = ["$schema", "name", "root", "paths", "work_offsets"];
/** Keys of a path, in the order in which files have them. */
export const pathKeys = ["name", ...setUpKeys, "targets"];

const isObject = (value: JsonValue | undefined): value is { [key: string]: JsonValue | undefined } =>
  typeof value === "object" && value !== null && !Array.isArray(value);

/** The first key that does not belong there, in words. */
const strange = (value: object, known: string[], where: string): string | null => {
  const key = Object.keys(value).find((each) => !known.includes(each));
  return key === undefined ? null : words.unknownKey(key, where, known.join(", "));
};

/** What keeps values of JSON from being a path file; the place is one of the text. */
function faultOfShape(value: JsonValue): { text: string; at: JsonPlace } | null {
  if (!isObject(value)) return { text: words.noObject, at: [] };
  const unknown = strange(value, FILE_KEYS, words.ofFile);
  if (unknown) return { text: unknown, at: [] };
  for (const key of ["name", "root", "$schema"]) {
    if (value[key] !== undefined && typeof value[key] !== "string") return { text: words.noString(key), at: [key] };
  }
  const { paths } = value;
  if (!Array.isArray(paths) || paths.length === 0) return { text: words.noPaths, at: [] };
  for (let i = 0; i < paths.length; ++i) {
    const fault = faultOfPath(paths[i]);
    if (fault) return { text: fault.text, at: ["paths", i, ...fault.at] };
  }
  return null;
}

function faultOfPath(path: JsonValue): { text: string; at: JsonPlace } | null {
  if (!isObject(path)) return { text: words.noPathObject, at: [] };
  const unknown = strange(path, pathKeys, words.ofPath);
  if (unknown) return { text: unknown, at: [] };
  if (typeof path.name !== "string" || path.name === "") return { text: words.noName, at: [] };
  const ofSetUp = faultOfSetUp(path);
  if (ofSetUp) return { text: ofSetUp, at: [] };
  const { targets } = path;
  if (!Array.isArray(targets) || targets.length === 0) return { text: words.noTargets(path.name), at: [] };
  for (let i = 0; i < targets.length; ++i) {
    const text = faultOfTarget(targets[i]);
    if (text) return { text, at: ["targets", i] };
  }
  return null;
}

/** With line and column. */
function faultAt(text: string, at: number, sentence: string): Fault {
  const before = text.slice(0, at);
  return { text: words.at(before.split("\n").length, at - before.lastIndexOf("\n"), sentence), place: null };
}

/** The path file, or why the text is none: with line and column. */
export function readPathFile(text: string): PathFile | Fault {
  try {
    const value = readJson(text);
    const fault = faultOfShape(value);
    if (!fault) return value as unknown as PathFile;
    return faultAt(text, spanOf(text, fault.at).from, fault.text);
  } catch (fault) {
    if (!(fault instanceof JsonFault)) throw fault;
    return faultAt(text, fault.at, fault.message);
  }
}

export const isPathFile = (read: PathFile | Fault): read is PathFile => "paths" in read;

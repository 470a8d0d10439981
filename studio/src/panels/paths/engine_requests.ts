// Requests of the path forms to the engine (docs/studio.md).

import type { EngineResponse } from "../../core/engine_response";
import type { Session } from "../../core/session";
import type { ListedContour } from "./contour_picks";

const decode = (bytes: unknown): string => new TextDecoder().decode(bytes as Uint8Array);

/** Returns the first message of a name; null: none came. */
const findMessage = ({ messages }: EngineResponse, name: string) => messages.find(({ is }) => is === name) ?? null;

/** Returns the messages of warnings. */
const warningTexts = ({ messages }: EngineResponse): string[] =>
  messages.flatMap(({ is, header }) => (is === "diagnostic" ? [String(header.text)] : []));

export interface RejectedRequest {
  refused: string;
}

export interface WrittenProgram {
  text: string;
  notes: string[];
  /** Further files by name. */
  files: Record<string, string>;
}

export interface WriteChoice {
  post: string;
  program_name: string;
  inch: boolean;
  offsets: string;
  rotary_as_given: boolean;
  verbose_words: boolean;
  separate_files: boolean;
  go_on: boolean;
  tolerance_mm: number | undefined;
  decimals_mm: number | undefined;
}

/** Writes a path as a part program for the machine of the setup. */
export async function writeProgram(session: Session, path: string, choice: WriteChoice): Promise<WrittenProgram | RejectedRequest> {
  const { machine, machine_data, cell } = session.setup;
  const response = await session.sendRequest({ do: "write", path, machine, machine_data, cell, ...choice });
  const message = findMessage(response, "program");
  if (!response.ok || !message) return { refused: response.message };
  const names = message.header.files as string[];
  const files = Object.fromEntries(names.map((name, i) => [name, decode(message.columns.get(`file${i}`))]));
  return { text: decode(message.columns.get("text")), notes: message.header.notes as string[], files };
}

/** Returns the names of the built-in posts. */
export async function posts(session: Session): Promise<string[]> {
  const message = findMessage(await session.sendRequest({ do: "posts" }), "posts");
  return (message?.header.names as string[] | undefined) ?? [];
}

/** Returns the names of the built-in materials. */
export async function materials(session: Session): Promise<string[]> {
  const message = findMessage(await session.sendRequest({ do: "materials" }), "materials");
  return ((message?.header.materials as { name: string }[] | undefined) ?? []).map(({ name }) => name);
}

export interface GeneratedPath {
  text: string;
  summary: string;
  job: string;
  warnings: string[];
}

/** Makes a path from a drawing, by the options of autopath. */
export async function generatePath(session: Session, request: Record<string, unknown>): Promise<GeneratedPath | RejectedRequest> {
  const response = await session.sendRequest({ do: "drawing", ...request });
  const message = findMessage(response, "path");
  if (!response.ok || !message) return { refused: response.message };
  const { summary, job_text } = message.header as Record<string, string>;
  return { text: decode(message.columns.get("text")), summary, job: job_text, warnings: warningTexts(response) };
}

export interface PartContours {
  contours: ListedContour[];
  /** Parts of the model that are left out, as messages. */
  notes: string[];
}

interface ContourHeader {
  face: string;
  is_hole: boolean;
  edges: string[];
  length_mm: number;
  depth_mm: number;
  tilt_deg: number;
  points: number;
}

/** Returns the contours of a part that could be cut. */
export async function readContours(session: Session, request: Record<string, unknown>): Promise<PartContours | RejectedRequest> {
  const response = await session.sendRequest({ do: "contours", ...request });
  const message = findMessage(response, "contours");
  if (!response.ok || !message) return { refused: response.message };
  const lines = message.columns.get("lines") as Float64Array;
  let at = 0;
  const contours = (message.header.contours as ContourHeader[]).map(({ is_hole, points, ...rest }) => {
    const polyline_mm = lines.subarray(at, (at += 3 * points));
    return { ...rest, isHole: is_hole, polyline_mm };
  });
  return { contours, notes: message.header.notes as string[] };
}

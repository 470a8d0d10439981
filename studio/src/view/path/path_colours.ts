// Meaning of the path colours: a class of each segment, or a quantity on a scale.

import { grey, kindColours, limitColours, scaleColour, vermilion, blue } from "../../core/colours";
import type { ColourMode } from "../../core/store";
import { Flag, limitKinds, moveKinds } from "../../run/kinds";
import { isRapid, decodeKind, decodeLimit, type Segments } from "../../run/segments";
import type { Chunk, RunSection } from "../../run/run_section";
import { ROW, rowCount, type PathData } from "./path_data";

export type ScaleMode = "feed" | "speed" | "time" | "deviation";
type ClassMode = Exclude<ColourMode, ScaleMode>;

/** Lowest and highest value on a scale: mm/min, mm/s, s or mm. */
export interface Scale {
  low: number;
  high: number;
}

/** Contents of a legend. */
export interface LegendKey {
  mode: ColourMode;
  scale: Scale | null;
  /** Names of the classes that occur, in the order of the codes. */
  classes: string[];
  /** True if it is not known for all of a long run. */
  isPartial: boolean;
}

const processStates = ["off", "on"] as const;

/** Mark of a vertex, stored with its colour. */
export const RAPID_MARK = 1;

interface Classes {
  names: readonly string[];
  code: (flags: number) => number;
  colours: Record<string, string>;
}

const classModes: Record<ClassMode, Classes> = {
  kind: { names: moveKinds, code: decodeKind, colours: kindColours },
  limit: { names: limitKinds, code: decodeLimit, colours: limitColours },
  process: {
    names: processStates,
    code: (flags) => (flags & Flag.processOn ? 1 : 0),
    colours: { off: grey, on: vermilion },
  },
};

const isScale = (mode: ColourMode): mode is ScaleMode => !(mode in classModes);

export const classColour = (mode: ColourMode, name: string): string =>
  isScale(mode) ? blue : classModes[mode].colours[name];

/** For a long run, true for values that are only known in the permanently loaded part. */
const needsChunks = (mode: ScaleMode): boolean => mode === "feed" || mode === "deviation";

/** Returns the quantity of a segment on a scale; NaN: none (the feed of a rapid move). */
function quantity(mode: ScaleMode, chunk: Chunk, i: number): number {
  switch (mode) {
    case "feed":
      return chunk.feed_per_min[i] > 0 ? chunk.feed_per_min[i] : NaN;
    case "speed":
      return chunk.duration_s[i] > 0 ? chunk.length_mm[i] / chunk.duration_s[i] : NaN;
    case "deviation":
      return chunk.deviation_mm[i];
    case "time":
      return chunk.start_s[i];
  }
}

/** Returns the stretches that are loaded only as vertices. */
const compactSections = (all: Segments[]): RunSection[] => all.flatMap(({ sections, chunks }) => sections.slice(chunks.length));

function computeScale(mode: ScaleMode, all: Segments[]): Scale {
  if (mode === "time") return { low: 0, high: Math.max(0, ...all.map((segments) => segments.end_s)) };
  const scale = { low: Infinity, high: -Infinity };
  const expand = (value: number) => {
    if (value < scale.low) scale.low = value;
    if (value > scale.high) scale.high = value;
  };
  for (const { chunks } of all) {
    for (const chunk of chunks) for (let i = 0; i < chunk.count; ++i) expand(quantity(mode, chunk, i));
  }
  for (const section of needsChunks(mode) ? [] : compactSections(all)) {
    for (let i = 0; i < section.vertices; ++i) expand(section.vertexSpeed_mm_s(i));
  }
  if (scale.low > scale.high) return { low: 0, high: 0 };
  // Speeds and deviations start at 0; feeds often differ so little that they need the full scale.
  return mode === "feed" ? scale : { low: 0, high: scale.high };
}

function occurringClasses({ names, code }: Classes, all: Segments[]): string[] {
  const seen = new Set<number>();
  for (const { chunks } of all) {
    for (const chunk of chunks) for (let i = 0; i < chunk.count; ++i) seen.add(code(chunk.flags[i]));
  }
  for (const section of compactSections(all)) for (let i = 0; i < section.vertices; ++i) seen.add(code(section.vertexFlags(i)));
  return names.filter((_, i) => seen.has(i));
}

export function legendKey(mode: ColourMode, all: Segments[]): LegendKey {
  if (!isScale(mode)) return { mode, scale: null, classes: occurringClasses(classModes[mode], all), isPartial: false };
  const isPartial = needsChunks(mode) && all.some((segments) => segments.isLong);
  return { mode, scale: computeScale(mode, all), classes: [], isPartial };
}

/** True if vertices have the same colours in both. */
export const areSameColours = (a: LegendKey, b: LegendKey | null): boolean =>
  a.mode === b?.mode && a.scale?.low === b.scale?.low && a.scale?.high === b.scale?.high;

const hexToBytes = (hex: string): number[] => [1, 3, 5].map((at) => parseInt(hex.slice(at, at + 2), 16));

type VertexColour = (section: RunSection, vertex: number) => ArrayLike<number>;

/** Returns NaN if the vertex has no value, or it is not loaded. */
function quantityAt(mode: ScaleMode, section: RunSection, vertex: number): number {
  if (mode === "time") return section.time_s(vertex);
  if (section.whole) return quantity(mode, section.whole, section.vertexSegment(vertex) - section.first);
  return mode === "speed" ? section.vertexSpeed_mm_s(vertex) : NaN;
}

function createVertexColour(key: LegendKey): VertexColour {
  if (!isScale(key.mode)) {
    const { names, code, colours } = classModes[key.mode];
    const table = names.map((name) => hexToBytes(colours[name]));
    return (section, i) => table[code(section.vertexFlags(i))] ?? table[0];
  }
  const mode = key.mode;
  const { low, high } = key.scale!;
  const steps = 255;
  const table = Array.from({ length: steps + 1 }, (_, i) => scaleColour(i / steps).map((part) => part * 255));
  const none = hexToBytes(grey);
  const factor = high > low ? steps / (high - low) : 0;
  return (section, i) => {
    const value = quantityAt(mode, section, i);
    return Number.isNaN(value) ? none : table[Math.min(steps, Math.round((value - low) * factor))];
  };
}

/**
 * Returns red, green and blue of vertices from one to before another, for a texture of full rows. RAPID_MARK
 * is set at the end of a rapid move.
 */
export function colourTexels(data: PathData, key: LegendKey, from: number, to: number): Uint8Array {
  const texels = new Uint8Array(4 * ROW * rowCount(to - from));
  const paint = createVertexColour(key);
  for (const { section, from: begin, to: end, vertex } of data.vertices(from, to)) {
    let at = 4 * (vertex - from);
    for (let i = begin; i < end; ++i, at += 4) {
      const colour = paint(section, i);
      texels[at] = colour[0];
      texels[at + 1] = colour[1];
      texels[at + 2] = colour[2];
      texels[at + 3] = isRapid(section.vertexFlags(i)) ? RAPID_MARK : 0;
    }
  }
  return texels;
}

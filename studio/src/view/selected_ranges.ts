// Vertices of the paths for given lines and blocks.

import type { State } from "../core/store";
import type { Robot, Run } from "../run/run";
import type { PathData } from "./path/path_data";

export type Range = [number, number];

// A line in a long loop has more blocks than can be distinguished.
const MAX_RANGES = 500;

export function blockRange({ blocks }: Robot, data: PathData, block: number): Range {
  return data.vertexRange(blocks.first(block), blocks.end(block));
}

/** Returns the ranges of the selection, for one robot; a block by number belongs to the shown robot. */
export function selectedRanges(run: Run, robot: number, data: PathData, state: Pick<State, "selection" | "robot">): Range[] {
  const { selection } = state;
  if (!selection) return [];
  const known = run.robots[robot];
  if (selection.block >= 0) {
    const own = robot === state.robot && known.blocks.first(selection.block) < known.segments.count;
    return own ? [blockRange(known, data, selection.block)] : [];
  }
  const [file, line] = [run.fileOf(robot, selection.file), selection.line];
  return sampleEvenly([known.blocks.blocksOfLine(file, line), known.blocks.behindTable({ file, line })]).map((block) =>
    blockRange(known, data, block),
  );
}

/** Returns all values if few, else about so many at even steps. */
function sampleEvenly(all: Iterable<number>[]): number[] {
  let some: number[] = [];
  let [step, count] = [1, 0];
  for (const each of all) {
    for (const value of each) {
      if (count++ % step === 0) some.push(value);
      if (some.length <= MAX_RANGES) continue;
      some = some.filter((_, i) => i % 2 === 0);
      step *= 2;
    }
  }
  return some;
}

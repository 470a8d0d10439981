// Of lines and blocks: which vertices of the ways they are.

import type { State } from "../core/store";
import type { Robot, Run } from "../run/run";
import type { PathData } from "./path/path_data";

export type Range = [number, number];

// A line in a long loop has more blocks than can be told apart.
const MOST_RANGES = 500;

export function rangeOfBlock({ blocks }: Robot, data: PathData, block: number): Range {
  return data.rangeOf(blocks.first.at(block), blocks.end(block));
}

/** Of the selection, for one robot; a block by number is one of the robot that is shown. */
export function chosenRanges(run: Run, robot: number, data: PathData, state: Pick<State, "selection" | "robot">): Range[] {
  const { selection } = state;
  if (!selection) return [];
  const known = run.robots[robot];
  if (selection.block >= 0) {
    const own = robot === state.robot && selection.block < known.blocks.count;
    return own ? [rangeOfBlock(known, data, selection.block)] : [];
  }
  const blocks = known.blocks.ofLine(run.fileOf(robot, selection.file), selection.line);
  const step = Math.ceil(blocks.length / MOST_RANGES) || 1;
  const ranges: Range[] = [];
  for (let i = 0; i < blocks.length; i += step) ranges.push(rangeOfBlock(known, data, blocks[i]));
  return ranges;
}

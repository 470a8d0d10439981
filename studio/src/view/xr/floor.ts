// Floor of the cell: lines, one metre apart.

import { BufferGeometry, LineSegments, type LineBasicMaterial } from "three";
import { setLines } from "../marks/grid";

/** Distance from its middle to its edge, m. */
const HALF_SIZE_M = 20;

/** Draws each line in parts of a metre: some renderers drop a line that continues behind the eye. */
export function createFloor(look: LineBasicMaterial): LineSegments<BufferGeometry, LineBasicMaterial> {
  const floor = new LineSegments(new BufferGeometry(), look);
  const ends: number[] = [];
  for (let line = -HALF_SIZE_M; line <= HALF_SIZE_M; ++line) {
    for (let at = -HALF_SIZE_M; at < HALF_SIZE_M; ++at) ends.push(at, 0, line, at + 1, 0, line, line, 0, at, line, 0, at + 1);
  }
  setLines(floor, ends);
  return floor;
}

// Selection of the path parts to draw: none outside the screen, and fewer if many lie in a pixel.

import type { Matrix4 } from "three";

/** Row of adjacent parts: the box around their vertices (mm), their number and length. */
export interface Row {
  low: number[];
  high: number[];
  pieces: number;
  length_mm: number;
}

/** Returns the row of parts between vertices from one to another; texels have x, y, z and a time for each. */
export function rowLength(texels: Float32Array, from: number, to: number): Row {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  let length_mm = 0;
  for (let at = 4 * from; at <= 4 * to; at += 4) {
    for (let k = 0; k < 3; ++k) {
      const value = texels[at + k];
      if (value < low[k]) low[k] = value;
      if (value > high[k]) high[k] = value;
    }
    if (at === 4 * from) continue;
    const [x, y, z] = [texels[at] - texels[at - 4], texels[at + 1] - texels[at - 3], texels[at + 2] - texels[at - 2]];
    length_mm += Math.sqrt(x * x + y * y + z * z);
  }
  return { low, high, pieces: to - from, length_mm };
}

/** Cells across and down the screen, for measuring the path density. */
const CELLS = 32;
/** Ratio of path length to pixels that looks like the complete path. */
const TARGET_DENSITY = 8;
/** Length of a step (px) that shows no corner between its ends. */
const MIN_STEP_PX = 0.7;
export const MAX_STRIDE = 64;

/** Row on the screen: cells from and to, its length in pixels, and path pixels for each pixel there. */
interface ProjectedRow {
  cells: [left: number, right: number, top: number, bottom: number];
  long_px: number;
  density: number;
}

/**
 * Returns `null` if it is outside the screen; "near" if it reaches behind the camera, so that its size is
 * unknown.
 */
function projectRow(row: Row, { elements: m }: Matrix4, width_px: number, height_px: number): ProjectedRow | "near" | null {
  let [left, right, low, high] = [Infinity, -Infinity, Infinity, -Infinity];
  for (let corner = 0; corner < 8; ++corner) {
    const x = corner & 1 ? row.high[0] : row.low[0];
    const y = corner & 2 ? row.high[1] : row.low[1];
    const z = corner & 4 ? row.high[2] : row.low[2];
    const w = m[3] * x + m[7] * y + m[11] * z + m[15];
    if (w <= 0) return "near";
    const u = (m[0] * x + m[4] * y + m[8] * z + m[12]) / w;
    const v = (m[1] * x + m[5] * y + m[9] * z + m[13]) / w;
    if (u < left) left = u;
    if (u > right) right = u;
    if (v < low) low = v;
    if (v > high) high = v;
  }
  if (right < -1 || left > 1 || high < -1 || low > 1) return null;
  const [wide_px, tall_px] = [0.5 * (right - left) * width_px, 0.5 * (high - low) * height_px];
  const size_mm = Math.hypot(row.high[0] - row.low[0], row.high[1] - row.low[1], row.high[2] - row.low[2]);
  const long_px = size_mm > 0 ? (row.length_mm * Math.hypot(wide_px, tall_px)) / size_mm : 0;
  const cell = (at: number) => Math.min(Math.max(Math.floor(0.5 * (at + 1) * CELLS), 0), CELLS - 1);
  // A path is at least a pixel wide.
  const density = long_px / (Math.max(wide_px, 1) * Math.max(tall_px, 1));
  return { cells: [cell(left), cell(right), cell(low), cell(high)], long_px, density };
}

/**
 * Returns for each row how many parts share one drawn part, a power of two; 0: not drawn. Rows overlap, so
 * the total path in that area of the screen counts.
 */
export function rowStrides(rows: readonly Row[], matrix: Matrix4, width_px: number, height_px: number): Uint8Array {
  const all = rows.map((row) => projectRow(row, matrix, width_px, height_px));
  const densities = new Float64Array(CELLS * CELLS);
  const each = ([left, right, low, high]: ProjectedRow["cells"], visit: (cell: number) => void) => {
    for (let v = low; v <= high; ++v) for (let u = left; u <= right; ++u) visit(CELLS * v + u);
  };
  for (const place of all) {
    if (place && place !== "near") each(place.cells, (cell) => (densities[cell] += place.density));
  }
  return Uint8Array.from(all, (place, i) => {
    if (!place) return 0;
    if (place === "near") return 1;
    let [inverse, count] = [0, 0];
    each(place.cells, (cell) => {
      inverse += 1 / densities[cell];
      ++count;
    });
    // The harmonic mean follows the smallest densities.
    const dense = count / inverse / TARGET_DENSITY;
    const small = (MIN_STEP_PX * rows[i].pieces) / place.long_px;
    const most = Math.min(Math.max(dense, small, 1), MAX_STRIDE);
    return 2 ** Math.floor(Math.log2(most));
  });
}

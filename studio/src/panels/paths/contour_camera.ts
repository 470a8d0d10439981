// Camera for lines in space, without perspective, and a search for lines near a position in the picture.

import type { Vector } from "../../run/path/vector";

/** Direction and zoom of the view. */
export interface Camera {
  /** Angle about Z, and up from the horizontal. */
  yaw_rad: number;
  elevation_rad: number;
  /** 1: all lines just fit as first shown. */
  zoom: number;
  /** Point at the centre of the picture, to the right and up from the middle of the lines. */
  pan_mm: readonly [right: number, up: number];
}

export interface Size {
  width: number;
  height: number;
}

/** Extent of the lines: their middle, and their width and height in the first camera. */
export interface Extent {
  middle: Vector;
  width_mm: number;
  height_mm: number;
}

const DEFAULT_YAW_OFFSET_rad = -0.5;
const DEFAULT_ELEVATION_rad = 0.4;
const STEEP_ELEVATION_rad = 1.1;
const SIDE_YAWS_rad: Record<string, number> = { x: 0, y: Math.PI / 2, "-x": Math.PI, "-y": -Math.PI / 2 };
const MARGIN = 0.88;

/** Returns a slightly oblique view of the faces that look to this side. */
export function initialCamera(side: string): Camera {
  const elevation_rad = side === "z" ? STEEP_ELEVATION_rad : side === "-z" ? -STEEP_ELEVATION_rad : DEFAULT_ELEVATION_rad;
  return { yaw_rad: (SIDE_YAWS_rad[side] ?? -Math.PI / 2) + DEFAULT_YAW_OFFSET_rad, elevation_rad, zoom: 1, pan_mm: [0, 0] };
}

/** Returns the camera after a drag across the picture. */
export function turned(camera: Camera, right_px: number, down_px: number): Camera {
  const RAD_PER_PX = 0.01;
  const elevation_rad = camera.elevation_rad + down_px * RAD_PER_PX;
  const most = Math.PI / 2;
  return { ...camera, yaw_rad: camera.yaw_rad - right_px * RAD_PER_PX, elevation_rad: Math.min(most, Math.max(-most, elevation_rad)) };
}

function directions({ yaw_rad, elevation_rad }: Camera): [right: Vector, up: Vector] {
  const [sin, cos, sinElevation] = [Math.sin(yaw_rad), Math.cos(yaw_rad), Math.sin(elevation_rad)];
  return [
    [-sin, cos, 0],
    [-sinElevation * cos, -sinElevation * sin, Math.cos(elevation_rad)],
  ];
}

/** Calls `visit` with each position as seen: to the right and up from the middle. */
function project(polyline_mm: Float64Array, middle: Vector, camera: Camera, visit: (right: number, up: number) => void): void {
  const [right, up] = directions(camera);
  for (let i = 0; i < polyline_mm.length; i += 3) {
    const [x, y, z] = [polyline_mm[i] - middle[0], polyline_mm[i + 1] - middle[1], polyline_mm[i + 2] - middle[2]];
    visit(x * right[0] + y * right[1] + z * right[2], x * up[0] + y * up[1] + z * up[2]);
  }
}

export function lineExtent(lines_mm: readonly Float64Array[], camera: Camera): Extent {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (const line of lines_mm) {
    line.forEach((value, i) => {
      low[i % 3] = Math.min(low[i % 3], value);
      high[i % 3] = Math.max(high[i % 3], value);
    });
  }
  const middle = low.map((value, i) => (value + high[i]) / 2) as unknown as Vector;
  let [width_mm, height_mm] = [0, 0];
  for (const line of lines_mm) {
    project(line, middle, camera, (right, up) => {
      width_mm = Math.max(width_mm, 2 * Math.abs(right));
      height_mm = Math.max(height_mm, 2 * Math.abs(up));
    });
  }
  return { middle, width_mm, height_mm };
}

/** Pixels of a mm. */
export function pixelsPerMm({ width_mm, height_mm }: Extent, { zoom }: Camera, { width, height }: Size): number {
  const MIN_EXTENT_mm = 1e-3;
  return MARGIN * zoom * Math.min(width / Math.max(width_mm, MIN_EXTENT_mm), height / Math.max(height_mm, MIN_EXTENT_mm));
}

/** Returns a zoomed camera that keeps a position of the picture fixed. */
export function zoomCamera(camera: Camera, factor: number, extent: Extent, size: Size, x: number, y: number): Camera {
  const [MIN_ZOOM, MAX_ZOOM] = [0.2, 200];
  const zoom = Math.min(MAX_ZOOM, Math.max(MIN_ZOOM, camera.zoom * factor));
  const [before, after] = [pixelsPerMm(extent, camera, size), pixelsPerMm(extent, { ...camera, zoom }, size)];
  const shift = 1 / before - 1 / after;
  const [right, up] = camera.pan_mm;
  return { ...camera, zoom, pan_mm: [right + (x - size.width / 2) * shift, up - (y - size.height / 2) * shift] };
}

/** Returns a line in the picture: x and y of each position. */
export function projectLine(polyline_mm: Float64Array, extent: Extent, camera: Camera, size: Size): Float32Array {
  const scale = pixelsPerMm(extent, camera, size);
  const [right, up] = camera.pan_mm;
  const line = new Float32Array((polyline_mm.length / 3) * 2);
  let at = 0;
  project(polyline_mm, extent.middle, camera, (x, y) => {
    line[at++] = size.width / 2 + (x - right) * scale;
    line[at++] = size.height / 2 - (y - up) * scale;
  });
  return line;
}

/** Returns the distance from a position to a line. */
function distance(line: Float32Array, x: number, y: number): number {
  let nearest = Infinity;
  for (let i = 2; i < line.length; i += 2) {
    const [fromX, fromY] = [line[i - 2], line[i - 1]];
    const [alongX, alongY] = [line[i] - fromX, line[i + 1] - fromY];
    const length2 = alongX * alongX + alongY * alongY;
    const share = length2 > 0 ? Math.min(1, Math.max(0, ((x - fromX) * alongX + (y - fromY) * alongY) / length2)) : 0;
    nearest = Math.min(nearest, Math.hypot(x - fromX - share * alongX, y - fromY - share * alongY));
  }
  return nearest;
}

/** Returns the line that is nearest to a position, and near enough; -1: none. */
export function nearestLine(lines: readonly Float32Array[], x: number, y: number, within_px: number): number {
  let [found, least] = [-1, within_px];
  lines.forEach((line, i) => {
    const each = distance(line, x, y);
    if (each < least) [found, least] = [i, each];
  });
  return found;
}

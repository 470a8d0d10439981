// Colours that people with red-green blindness can distinguish (Okabe and Ito, 2008; viridis for scales).

import type { LimitOrDwell } from "../run/limits";
import type { MoveKind } from "../run/kinds";

export const orange = "#e69f00";
export const sky = "#56b4e9";
export const green = "#009e73";
export const yellow = "#f0e442";
export const blue = "#0072b2";
export const vermilion = "#d55e00";
export const purple = "#cc79a7";
export const grey = "#8a8f98";

export const kindColours: Record<MoveKind, string> = {
  rapid: orange,
  linear: blue,
  arc_cw: green,
  arc_ccw: sky,
  dwell: grey,
  probe: purple,
  thread: yellow,
  spline: vermilion,
};

export const limitColours: Record<LimitOrDwell, string> = {
  feed: blue,
  path_speed: sky,
  joint_speed: green,
  acceleration: orange,
  path_acceleration: "#b8860b",
  centripetal: yellow,
  corner: vermilion,
  stop: purple,
  jerk: "#7a5195",
  look_ahead: "#444b59",
  block_time: "#5e3c99",
  time: grey,
  rapid_override: "#a6761d",
  short_brakes: "#8c2d04",
  unknown: grey,
  dwell: grey,
};

const axisColours = [vermilion, green, blue, purple, orange, sky, yellow, grey];

/** Returns the colour of an axis by its number. */
export const axisColour = (axis: number): string => axisColours[axis % axisColours.length];

const viridis = [
  [68, 1, 84],
  [71, 44, 122],
  [59, 81, 139],
  [44, 113, 142],
  [33, 144, 141],
  [39, 173, 129],
  [92, 200, 99],
  [170, 220, 50],
  [253, 231, 37],
];

/** Returns red, green, blue (0 to 1) at a share of the scale from 0 to 1. */
export function scaleColour(share: number): [number, number, number] {
  const at = Math.min(Math.max(share, 0), 1) * (viridis.length - 1);
  const low = Math.min(Math.floor(at), viridis.length - 2);
  const part = at - low;
  const mix = (i: number) => (viridis[low][i] * (1 - part) + viridis[low + 1][i] * part) / 255;
  return [mix(0), mix(1), mix(2)];
}

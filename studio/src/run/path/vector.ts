// Points and directions of three numbers.

export type Vector = [number, number, number];

export const add = (a: Vector, b: Vector): Vector => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const subtract = (a: Vector, b: Vector): Vector => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const scaled = (a: Vector, by: number): Vector => [a[0] * by, a[1] * by, a[2] * by];
export const dot = (a: Vector, b: Vector): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a: Vector, b: Vector): Vector => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];
export const vectorLength = (a: Vector): number => Math.hypot(a[0], a[1], a[2]);
export const distance = (a: Vector, b: Vector): number => vectorLength(subtract(a, b));
/** Returns a vector of length 1, or null if `a` has no length. */
export function unit(a: Vector): Vector | null {
  const length = vectorLength(a);
  return length > 1e-12 ? scaled(a, 1 / length) : null;
}
export const between = (a: Vector, b: Vector, share: number): Vector => add(a, scaled(subtract(b, a), share));

/** Rotates about an axis of length 1, right-handed. */
export function turned(a: Vector, axis: Vector, angle_rad: number): Vector {
  const [c, s] = [Math.cos(angle_rad), Math.sin(angle_rad)];
  return add(add(scaled(a, c), scaled(cross(axis, a), s)), scaled(axis, dot(axis, a) * (1 - c)));
}

const DIGITS = 1e6;

/** Rounds as written into a file: to a millionth of a mm or degree. */
export const rounded = (value: number): number => Math.round(value * DIGITS) / DIGITS + 0;
export const roundedVector = (a: Vector): Vector => [rounded(a[0]), rounded(a[1]), rounded(a[2])];

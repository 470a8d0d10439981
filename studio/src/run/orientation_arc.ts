// Path of a tilting head's two joints that turns the tool along a great circle (Clairaut's relation).

/** Size of an orientation arc in a record: turning and tilting joint, and thirteen constants. */
export const HEAD_SIZE = 15;

export interface HeadPoint {
  turnJoint: number;
  tiltJoint: number;
  /** Angle in rad, and its first and second derivative by the angle along the circle. */
  turn: [number, number, number];
  tilt: [number, number, number];
}

export const headLength_rad = (values: Float64Array, at: number): number => values[at + 14];

export function headAt(values: Float64Array, at: number, angle_rad: number): HeadPoint {
  const [turnJoint, tiltJoint, anchorTurn, anchorTilt, , sine, cosine, headingSine, headingCosine, side, clairaut] =
    values.subarray(at, at + 11);
  const from = values[at + 13] + angle_rad;
  const s = Math.sin(from);
  const c = Math.cos(from);
  const turn = anchorTurn + values[at + 11] * from;
  const tilt = anchorTilt + values[at + 12] * from;
  if (clairaut === 0) {
    return { turnJoint, tiltJoint, turn: [turn, 0, 0], tilt: [tilt + headingCosine * from, headingCosine, 0] };
  }
  const across = c * sine + s * cosine * headingCosine;
  const lateral = s * headingSine;
  const tiltSine = side * Math.max(Math.hypot(across, lateral), Math.abs(clairaut));
  const tiltCosine = c * cosine - s * sine * headingCosine;
  const slope = -s * cosine - c * sine * headingCosine;
  const cube = tiltSine ** 3;
  const tiltRate = -slope / tiltSine;
  return {
    turnJoint,
    tiltJoint,
    turn: [
      turn + Math.atan2(side * lateral, side * across),
      clairaut / tiltSine ** 2,
      (-2 * clairaut * tiltCosine * tiltRate) / cube,
    ],
    tilt: [
      tilt + Math.atan2(tiltSine, tiltCosine) - Math.atan2(sine, cosine),
      tiltRate,
      (clairaut ** 2 * tiltCosine) / cube,
    ],
  };
}

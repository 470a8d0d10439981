// Time laws: distance of a motion on its path at an instant. The closed forms are the engine's, in 64 bits.
// So the page shows the exact position of the machine and not that of a drawing.

export interface LawState {
  /** Distance, speed and acceleration along the path (mm or rad, s). */
  s: number;
  v: number;
  a: number;
}

/**
 * Header of a law in a record: length, duration, end speed, number of parts; five numbers for each part
 * follow.
 */
const HEADER_SIZE = 4;
const SECTION_SIZE = 5;

export const lawSize = (values: Float64Array, at: number): number => HEADER_SIZE + SECTION_SIZE * values[at + 3];
export const lawLength = (values: Float64Array, at: number): number => values[at];
export const lawDuration_s = (values: Float64Array, at: number): number => values[at + 1];

/** Returns the state of the law that begins at `at`, `t_s` after its start; clamped at both ends. */
export function lawAt(values: Float64Array, at: number, t_s: number): LawState {
  const length = values[at];
  const duration_s = values[at + 1];
  const count = values[at + 3];
  if (count === 0) return { s: length, v: values[at + 2], a: 0 };
  const over = t_s >= duration_s;
  let t = t_s;
  let section = at + HEADER_SIZE;
  const last = section + SECTION_SIZE * (count - 1);
  while (section < last && (over || t > values[section])) {
    t -= values[section];
    section += SECTION_SIZE;
  }
  // The last part is counted from the end, so it reaches standstill exactly, however long the others are.
  const own_s = values[section];
  if (section === last) t = own_s - (duration_s - t_s);
  t = Math.min(Math.max(t, 0), own_s);
  const [s0, v0, a0, jerk] = [values[section + 1], values[section + 2], values[section + 3], values[section + 4]];
  const s = s0 + t * (v0 + t * (a0 / 2 + (t * jerk) / 6));
  return {
    s: over ? length : Math.min(Math.max(s, 0), length),
    v: Math.max(v0 + t * (a0 + (t * jerk) / 2), 0),
    a: a0 + t * jerk,
  };
}

/** Returns an empty range: lowest and highest speed, lowest and highest acceleration. */
export const newRange = (): Float64Array => new Float64Array([Infinity, -Infinity, Infinity, -Infinity]);

/** Widens a range of speeds and accelerations by those of the law. */
export function extendByLaw(values: Float64Array, at: number, range: Float64Array): void {
  const end = at + lawSize(values, at);
  if (end === at + HEADER_SIZE) extendBySpeed(range, values[at + 2]);
  for (let section = at + HEADER_SIZE; section < end; section += SECTION_SIZE) {
    const duration_s = values[section];
    const [v0, a0, jerk] = [values[section + 2], values[section + 3], values[section + 4]];
    const a1 = a0 + duration_s * jerk;
    extendBySpeed(range, v0);
    extendBySpeed(range, v0 + (duration_s * (a0 + a1)) / 2);
    if (a0 * a1 < 0) extendBySpeed(range, v0 - (a0 * a0) / (2 * jerk));
    range[2] = Math.min(range[2], a0, a1);
    range[3] = Math.max(range[3], a0, a1);
  }
}

function extendBySpeed(range: Float64Array, speed: number): void {
  const v = Math.max(speed, 0);
  if (v < range[0]) range[0] = v;
  if (v > range[1]) range[1] = v;
}

/** Adds the instants between the parts of the law, without its start and end. */
export function addBreaks_s(values: Float64Array, at: number, breaks_s: number[]): void {
  let t_s = 0;
  for (let section = 0; section < values[at + 3] - 1; ++section) {
    t_s += values[at + HEADER_SIZE + SECTION_SIZE * section];
    breaks_s.push(t_s);
  }
}

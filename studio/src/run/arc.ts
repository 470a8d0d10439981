// Circles, helices and the spirals that rounded centres make: position, speed and acceleration of the three
// joints that carry them.

/** Size of an arc in a record: three joints, centre, u, v, radius, end radius, sweep, lift. */
export const ARC_SIZE = 18;

export interface ArcPoint {
  position: number[];
  velocity: number[];
  acceleration: number[];
}

export function arcAt(values: Float64Array, at: number, s: number, v: number, a: number): ArcPoint {
  const center = at + 3;
  const u = at + 6;
  const w = at + 9;
  const radius = values[at + 12];
  const change = values[at + 13] - radius;
  const sweep = values[at + 14];
  const lift = at + 15;
  const lift2 = values[lift] ** 2 + values[lift + 1] ** 2 + values[lift + 2] ** 2;
  const growth = change / radius;
  const logGrowth = Math.log1p(growth);
  // The series is for values near 0, for which change / log(1 + growth) is 0 / 0.
  const mean =
    Math.abs(growth) > 1e-4 ? change / logGrowth : radius * (1 + growth * (1 / 2 - growth * (1 / 12 - growth / 24)));
  const arc_length_mm = sweep * mean;
  const length = Math.sqrt(change * change + arc_length_mm * arc_length_mm + lift2);
  const share = s / length;
  const phi = change === 0 ? sweep * share : (sweep * Math.log1p((change / radius) * share)) / logGrowth;
  const here = radius + change * share;
  const cosine = Math.cos(phi);
  const sine = Math.sin(phi);
  const [radial, around] = [change / length, arc_length_mm / length];
  const position = [0, 0, 0];
  const velocity = [0, 0, 0];
  const acceleration = [0, 0, 0];
  for (let i = 0; i < 3; ++i) {
    const outward = cosine * values[u + i] + sine * values[w + i];
    const forward = cosine * values[w + i] - sine * values[u + i];
    const tangent = radial * outward + around * forward + values[lift + i] / length;
    position[i] = values[center + i] + here * outward + share * values[lift + i];
    velocity[i] = v * tangent;
    acceleration[i] = a * tangent + ((v * v * around) / here) * (radial * forward - around * outward);
  }
  return { position, velocity, acceleration };
}

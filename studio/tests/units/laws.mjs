// Laws, arcs and great circles against their numeric derivatives.

import assert from "node:assert/strict";
import { lawOf, near, slope, steady } from "./made.mjs";

export const modules = ["run/time_law", "run/arc", "run/orientation_arc", "run/evaluate", "run/kinds"];

/** From standstill with jerk, at a speed, and to standstill: 4 s. */
const curve = Float64Array.from(lawOf(0, [[1, 0, 6], [2, 0, 0], [1, 0, -6]]));

const inside = (from, to, count = 37) => Array.from({ length: count }, (_, i) => from + ((i + 0.5) * (to - from)) / count);

/** Position, speed and acceleration of a joint, all by time, are derivatives of each other. */
function derive(at, instants, tolerance = 1e-5) {
  for (const t_s of instants) {
    const { position, velocity, acceleration } = at(t_s);
    for (let j = 0; j < position.length; ++j) {
      near(velocity[j], slope((t) => at(t).position[j], t_s), tolerance, `speed of ${j} at ${t_s}:`);
      near(acceleration[j], slope((t) => at(t).velocity[j], t_s), tolerance, `acceleration of ${j} at ${t_s}:`);
    }
  }
}

// Plane tilted relative to all axes; u, v and the upward direction are at right angles.
const u = [2 / 3, 2 / 3, 1 / 3];
const v = [-2 / 3, 1 / 3, 2 / 3];
const up = [1 / 3, -2 / 3, 2 / 3];
const arcOf = ({ radius, end = radius, sweep, lift = 0 }) =>
  Float64Array.from([0, 1, 2, 5, 6, 7, ...u, ...v, radius, end, sweep, ...up.map((x) => lift * x)]);

function arcLength({ radius, end = radius, sweep, lift = 0 }) {
  const growth = Math.log(end / radius);
  const around = growth === 0 ? radius * sweep : (sweep * (end - radius)) / growth;
  return Math.hypot(end - radius, around, lift);
}

const arcs = {
  circle: { radius: 12, sweep: 4 },
  "circle the other way": { radius: 12, sweep: -4 },
  helix: { radius: 3, sweep: 9, lift: 20 },
  spiral: { radius: 10, end: 14, sweep: 2.5 },
  "spiral that hardly grows": { radius: 10, end: 10.00001, sweep: 2.5 },
  "helix that grows narrow": { radius: 10, end: 6, sweep: -5, lift: -8 },
};

/** A head's record: from a tilt of 0.7 rad with a heading of 1.1 rad, 0.9 rad along the circle. */
function headRecord() {
  const [tilt, heading] = [0.7, 1.1];
  const [sine, cosine] = [Math.sin(tilt), Math.cos(tilt)];
  const clairaut = sine * Math.sin(heading);
  return [0, 1, 0.3, 0.2, tilt, sine, cosine, Math.sin(heading), Math.cos(heading), 1, clairaut, 0, 0, 0, 0.9];
}

export default {
  "a law's speed and acceleration are derivatives of its way": ({ lawAt }) => {
    for (const t_s of [...inside(0, 1), ...inside(1, 3), ...inside(3, 4)]) {
      const { v: speed, a } = lawAt(curve, 0, t_s);
      near(speed, slope((t) => lawAt(curve, 0, t).s, t_s), 1e-6, "speed");
      near(a, slope((t) => lawAt(curve, 0, t).v, t_s), 1e-6, "acceleration");
    }
  },

  "a law rests at both ends, and does not go beyond them": ({ lawAt, lawLength }) => {
    assert.deepEqual(lawAt(curve, 0, -1), { s: 0, v: 0, a: 0 });
    near(lawLength(curve, 0), 1 + 6 + 2, 1e-12);
    for (const t_s of [4, 5, 1e9]) {
      assert.equal(lawAt(curve, 0, t_s).s, 9);
      near(lawAt(curve, 0, t_s).v, 0, 1e-12);
    }
  },

  "a law without pieces is at its end, at its end's speed": ({ lawAt, lawSize }) => {
    const none = Float64Array.from([7, 0, 3, 0]);
    assert.deepEqual(lawAt(none, 0, 0), { s: 7, v: 3, a: 0 });
    assert.equal(lawSize(none, 0), 4);
  },

  "the range of a law is what it comes to, and no more": ({ lawAt, newRange, extendByLaw }) => {
    // Up and down again within one part: the highest speed is in its middle.
    const hump = Float64Array.from(lawOf(1, [[2, 3, -3]]));
    const range = newRange();
    extendByLaw(hump, 0, range);
    const all = inside(0, 2, 2001).map((t_s) => lawAt(hump, 0, t_s));
    near(range[0], Math.min(...all.map((state) => state.v)), 5e-3);
    near(range[1], 2.5, 1e-12);
    near(range[2], -3, 1e-12);
    near(range[3], 3, 1e-12);
    for (const state of all) assert.ok(state.v <= range[1] && state.v >= range[0]);
  },

  "breaks of a law stand between its pieces": ({ addBreaks_s }) => {
    const breaks_s = [];
    addBreaks_s(curve, 0, breaks_s);
    assert.deepEqual(breaks_s, [1, 3]);
  },

  "arcs go at the speed of their lead, along what they are": ({ arcAt }) => {
    for (const [name, arc] of Object.entries(arcs)) {
      const values = arcOf(arc);
      const length = arcLength(arc);
      const at = (t) => arcAt(values, 0, 0.25 * t * t, 0.5 * t, 0.5);
      derive(at, inside(0.5, 2 * Math.sqrt(length) - 0.1, 11), 1e-4);
      for (const s of inside(0, length, 9)) near(Math.hypot(...arcAt(values, 0, s, 3, 0).velocity), 3, 1e-9, name);
    }
  },

  "arcs begin and end where they should": ({ arcAt }) => {
    for (const [name, arc] of Object.entries(arcs)) {
      const { radius, end = radius, sweep, lift = 0 } = arc;
      const values = arcOf(arc);
      const [first, last] = [0, arcLength(arc)].map((s) => arcAt(values, 0, s, 1, 0).position);
      for (let i = 0; i < 3; ++i) {
        near(first[i], 5 + i + radius * u[i], 1e-9, `${name}, start`);
        const out = end * (Math.cos(sweep) * u[i] + Math.sin(sweep) * v[i]);
        near(last[i], 5 + i + out + lift * up[i], 1e-7, `${name}, end`);
      }
    }
  },

  "a tilting head's joints are derivatives of each other along the great circle": ({ headAt }) => {
    const values = Float64Array.from(headRecord());
    for (const angle of inside(0, 0.9)) {
      for (const part of ["turn", "tilt"]) {
        const of = (order) => (at) => headAt(values, 0, at)[part][order];
        near(of(1)(angle), slope(of(0), angle), 1e-6, `${part}, first`);
        near(of(2)(angle), slope(of(1), angle), 1e-6, `${part}, second`);
      }
    }
  },

  "a tool on a great circle turns as fast as the angle grows": ({ headAt }) => {
    const values = Float64Array.from(headRecord());
    const direction = (angle) => {
      const { turn, tilt } = headAt(values, 0, angle);
      const [from_pole, around] = [tilt[0] - 0.2 + 0.7, turn[0]];
      return [Math.sin(from_pole) * Math.cos(around), Math.sin(from_pole) * Math.sin(around), Math.cos(from_pole)];
    };
    const start = direction(0);
    for (const angle of inside(0, 0.9)) {
      const cosine = direction(angle).reduce((sum, x, i) => sum + x * start[i], 0);
      near(Math.acos(cosine), angle, 1e-9);
    }
  },

  "joints of a record go by the law of the lead, from start to end": ({ jointsAt }) => {
    const values = Float64Array.from([1, 2, 10, -4, ...curve, 0]);
    const at = (t_s) => jointsAt({ values, joints: 2 }, { at: 0, flags: 1, duration_s: 4 }, t_s);
    derive(at, [...inside(0, 1), ...inside(1, 3), ...inside(3, 4)]);
    assert.deepEqual([...at(0).position], [1, 2]);
    assert.deepEqual([...at(4).position], [10, -4]);
    near(at(2).position[0], 5);
  },

  "a joint that follows has a law of its own, and may go backwards": ({ jointsAt, lawBreaks_s, isProportional }) => {
    const own = lawOf(0, [[2, 1, 0], [2, -1, 0]]);
    const values = Float64Array.from([0, 20, 9, 16, ...curve, 1, 1, -1, ...own]);
    const [records, part] = [{ values, joints: 2 }, { at: 0, flags: 1, duration_s: 4 }];
    const at = (t_s) => jointsAt(records, part, t_s);
    derive(at, [...inside(0, 1), ...inside(1.1, 1.9), ...inside(2.1, 2.9), ...inside(3, 4)]);
    near(at(2).position[1], 18);
    assert.deepEqual(lawBreaks_s(records, part).sort(), [1, 2, 3]);
    assert.equal(isProportional(records, part), false);
  },

  "a motion beside adds its way to this one's": ({ jointsAt, pathSpeed, pathAcceleration, Flag }) => {
    const beside = [3, 0, 3, 8, ...steady(8, 4), 0];
    const values = Float64Array.from([0, 0, 9, 0, ...curve, 0, 1, 4, ...beside]);
    const [records, part] = [{ values, joints: 2 }, { at: 0, flags: 1 | Flag.beside, duration_s: 4 }];
    const at = (t_s) => jointsAt(records, part, t_s);
    derive(at, [...inside(0, 1), ...inside(1, 3), ...inside(3, 4)]);
    assert.deepEqual([...at(4).position], [9, 8]);
    const speed = (t_s) => pathSpeed(records, part, t_s, 0, [0, 1]);
    near(speed(2), Math.hypot(3, 2));
    for (const t_s of inside(0.1, 0.9)) near(pathAcceleration(records, part, t_s, 0, [0, 1]), slope(speed, t_s), 1e-5);
  },

  "axes that go apart each come to rest by themselves": ({ jointsAt, pathSpeed, Flag }) => {
    const values = Float64Array.from([0, 0, 9, 1, ...curve, 1, 1, 1, ...steady(1, 0.5), 1]);
    const [records, part] = [{ values, joints: 2 }, { at: 0, flags: Flag.apart, duration_s: 4 }];
    const state = jointsAt(records, part, 3.5);
    assert.deepEqual([state.position[1], state.velocity[1], state.acceleration[1]], [1, 0, 0]);
    near(pathSpeed(records, part, 2, 0, []), 3);
  },
};

// Poses of links, tool and cell frames, and their motion by drifts.

import assert from "node:assert/strict";
import { moved, near, scene } from "./made.mjs";

export const modules = ["run/chain"];

const origin = (matrix) => matrix.elements.slice(12, 15);

function at(matrix, expected) {
  origin(matrix).forEach((value, i) => near(value, expected[i], 1e-9, `of ${expected}`));
}

const still = [0, 0, 0];
const frames = [
  { name: "base", link: 0, in_link: moved(0, 0, 0) },
  { name: "conveyor", parent: 0, in_parent: moved(100, 0, 0) },
  { name: "part", parent: 1, in_parent: moved(0, 5, 0) },
];
const uniformMotion = (frame, from_s, pose, velocity_mm_s, spin_rad_s = still) => ({ frame, from_s, pose, velocity_mm_s, spin_rad_s });

export default {
  "joints move their links along and about Z, the tool last": ({ Chain }) => {
    const chain = new Chain(scene());
    at(chain.linkPoses([0, 0], 0).tool, [11, 2, 3]);
    const linkPoses = chain.linkPoses([7, Math.PI / 2], 0);
    at(linkPoses.links[0], [0, 0, 0]);
    at(linkPoses.links[1], [1, 2, 10]);
    at(linkPoses.tool, [1, 12, 10]);
    at(linkPoses.work, [0, 0, 0]);
  },

  "a base puts all of the machine elsewhere": ({ Chain }) => {
    const linkPoses = new Chain(scene({ base: moved(1000, 0, 0) })).linkPoses([0, 0], 0);
    at(linkPoses.tool, [1011, 2, 3]);
    at(linkPoses.work, [1000, 0, 0]);
  },

  "axes are read in degrees from where their joint is at 0": ({ axisValue, jointValue }) => {
    const axis = { zero: 30, rotary: true };
    near(axisValue(axis, Math.PI / 2), 120, 1e-12);
    near(jointValue(axis, axisValue(axis, 0.4)), 0.4, 1e-12);
    assert.equal(axisValue({ zero: -5, rotary: false }, 12), 7);
  },

  "a drifting frame takes along what is attached to it": ({ Chain }) => {
    const chain = new Chain(scene({ frames, drifts: [uniformMotion(1, 2, moved(100, 0, 0), [10, 0, 0])] }));
    assert.equal(chain.drifting, true);
    at(chain.linkPoses([0, 0], 1).frames[1], [100, 0, 0]);
    at(chain.linkPoses([0, 0], 5).frames[1], [130, 0, 0]);
    at(chain.linkPoses([0, 0], 5).frames[2], [130, 5, 0]);
  },

  "a drift holds until the next of its frame, and turns about its own origin": ({ Chain }) => {
    const turning = uniformMotion(1, 6, moved(50, 0, 0), still, [0, 0, Math.PI / 4]);
    const chain = new Chain(scene({ frames, drifts: [uniformMotion(1, 2, moved(100, 0, 0), [10, 0, 0]), turning] }));
    at(chain.linkPoses([0, 0], 5.9).frames[1], [139, 0, 0]);
    const { frames: placed } = chain.linkPoses([0, 0], 8);
    at(placed[1], [50, 0, 0]);
    at(placed[2], [45, 0, 0]);
  },

  "a drift that is told anew from an earlier time replaces those behind it": ({ Chain }) => {
    const drifts = [uniformMotion(1, 2, moved(100, 0, 0), [10, 0, 0]), uniformMotion(1, 2, moved(100, 0, 0), [0, 1, 0])];
    at(new Chain(scene({ frames, drifts })).linkPoses([0, 0], 4).frames[1], [100, 2, 0]);
  },

  "where the base drifts the machine goes along, and the work stays": ({ Chain }) => {
    const drifts = [uniformMotion(0, 0, moved(1, 2, 3), [0, 20, 0])];
    const linkPoses = new Chain(scene({ frames, drifts })).linkPoses([0, 0], 2);
    at(linkPoses.tool, [11, 42, 3]);
    at(linkPoses.work, [0, 0, 0]);
    at(linkPoses.frames[0], [1, 42, 3]);
  },
};

#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include <tl/expected.hpp>

#include "toolpath/model/path.h"
#include "toolpath/model/validate.h"
#include "toolpath/rotary/machine_space.h"

namespace gsim::path {

/// Puts a path elsewhere as a whole: each point p, in mm of the work frame, comes to `motion` p, and the tool
/// turns along. Of rotary axes that the path names, the one that turns the tool about the motion's axis turns
/// by its angle, so that what is between two points keeps its shape; where there is none, points get the
/// tool's axis instead, and have to name all rotary axes. Fixed and reference points stay. The error: the
/// path was recorded, is in several work frames or finds them by touches, rotary axes are missing, or the
/// machine has none that could turn its tool along.
tl::expected<void, Fault> place(Program& program, const rrs::CartPos& motion, const MachineSpace& space);

/// Goes through the targets of the root in another order: the places of `order` are those that the file has,
/// from 0. The error: it is none of these, or the targets are not sub-paths that mean the same wherever they
/// stand: each has an orientation and a feed of its own, and nothing that one of them switches is on in the
/// next one.
tl::expected<void, Fault> reorder(Program& program, std::span<const std::size_t> order,
                                  const MachineSpace& space);

/// What becomes of feeds (mm/min); those by turns of the spindle go along. Times of single motions
/// (duration_s) and feeds of rotary axes alone stay.
struct FeedChange {
    std::string path = {};  ///< A name; empty: of all paths.
    double value = 1;       ///< > 0; mm/min, or a factor of what the path has.
    bool is_factor = true;
};
/// The error, a sentence: there is no such path, it has no feeds, or another one would take its feed over.
tl::expected<void, std::string> change_feeds(Program& program, const FeedChange& change);

}  // namespace gsim::path

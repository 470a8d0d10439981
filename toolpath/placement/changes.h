#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include <tl/expected.hpp>

#include "base/error.h"
#include "toolpath/model/path.h"
#include "toolpath/model/validate.h"
#include "toolpath/rotary/machine_space.h"

namespace gsim::path {

/// Moves a complete path to another position: each point p, in mm of the work frame, comes to `motion` p, and
/// the tool turns with it. If the path names rotary axes, the one that turns the tool about the motion's axis
/// turns by its angle. So the shape between two points stays. Without such an axis points get the tool's axis
/// instead, and must name all rotary axes. Fixed and reference points stay. The error: the path was recorded,
/// is in several work frames or finds them by touches. Or rotary axes are missing, or the machine has none
/// that could turn its tool as well.
tl::expected<void, TargetError> place(Program& program, const rrs::CartPos& motion,
                                      const MachineSpace& space);

/// Runs the targets of the root in another order: `order` holds their positions in the file, from 0. The
/// error: it does not hold each of these, or the targets are not sub-paths that mean the same at any
/// position. Each must have its own orientation and feed, and nothing that one of them switches may be on in
/// the next one.
tl::expected<void, TargetError> reorder(Program& program, std::span<const std::size_t> order,
                                        const MachineSpace& space);

/// Change of feeds (mm/min); feeds per turn of the spindle change with them. Times of single motions
/// (duration_s) and feeds of rotary axes alone stay.
struct FeedChange {
    std::string path = {};  ///< A name; empty: of all paths.
    double value = 1;       ///< > 0; mm/min, or a factor of what the path has.
    bool is_factor = true;
};
/// Changes feeds. The error, a message: the path does not exist, it has no feeds, or another one would
/// inherit its feed.
Result<void> change_feeds(Program& program, const FeedChange& change);

}  // namespace gsim::path

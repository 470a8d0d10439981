#pragma once

#include <memory>

#include "engine/columns.h"
#include "runtime/monitors/following_motion.h"
#include "runtime/outputs/run_output.h"

namespace gsim::engine {

/// Returns an output that delivers the actual positions of axes and TCP as columns.
std::unique_ptr<simulation::RunOutput> make_following_output(FollowingHandler callback,
                                                             const simulation::FollowingSetup& setup);

}  // namespace gsim::engine

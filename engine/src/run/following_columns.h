#pragma once

#include <memory>

#include "engine/columns.h"
#include "runtime/monitors/following_motion.h"
#include "runtime/outputs/run_output.h"

namespace gsim::engine {

/// An output that hands out where axes and tip really are as columns.
std::unique_ptr<simulation::RunOutput> hand_out_following(TakeFollowing take,
                                                          const simulation::FollowingSetup& setup);

}  // namespace gsim::engine

#pragma once

#include "engine/scene.h"
#include "runtime/simulator/simulator.h"

namespace gsim::engine {

/// Returns the scene of a simulator, with the independent motion of frames so far. `base`: pose of the
/// machine's world in that of all robots.
Scene make_scene(const simulation::Simulator& simulator, const rrs::CartPos& base = rrs::CartPos::Identity());

}  // namespace gsim::engine

#pragma once

#include "engine/scene.h"
#include "runtime/simulator/simulator.h"

namespace gsim::engine {

/// The scene of a simulator, with what it has seen so far of frames that go by themselves. `base`: of the
/// machine's world in that of all robots.
Scene scene_of(const simulation::Simulator& simulator, const rrs::CartPos& base = rrs::CartPos::Identity());

}  // namespace gsim::engine

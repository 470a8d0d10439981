#pragma once

#include "engine/scene.h"
#include "runtime/simulation/simulator.h"

namespace gsim::engine {

/// The scene of a simulator, with what it has seen so far of frames that go by themselves.
Scene scene_of(const simulation::Simulator& simulator);

}  // namespace gsim::engine

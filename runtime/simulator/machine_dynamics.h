#pragma once

#include <memory>
#include <string>

#include <tl/expected.hpp>

#include "geometry/mesh/mesh_file.h"
#include "machine/model/machine.h"
#include "motion/dynamics/dynamics.h"
#include "motion/planner/move_limits.h"

namespace gsim::simulation {

/// Returns the dynamics that a machine file describes: [dynamics], [[mass]], [[hose]], the drives of its axes
/// and the densities of its shapes. Reads the meshes of the shapes. Returns null if it has no [dynamics]. The
/// error is a message that names the shape.
tl::expected<std::shared_ptr<const dynamics::Dynamics>, std::string> make_dynamics(
    const machine::Machine& machine, const cell::MeshFiles& files = {});

/// Returns the limits from the peaks of its motors; null if they do not limit its accelerations. `dynamics`
/// is that of the machine.
std::shared_ptr<const motion::MoveLimits> make_effort_limits(
    const machine::Machine& machine, std::shared_ptr<const dynamics::Dynamics> dynamics);

}  // namespace gsim::simulation

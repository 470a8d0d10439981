#pragma once

#include <memory>
#include <string>

#include <tl/expected.hpp>

#include "geometry/mesh/mesh_file.h"
#include "machine/model/machine.h"
#include "motion/dynamics/dynamics.h"
#include "motion/planner/move_limits.h"

namespace gsim::simulation {

/// The dynamics that a machine file describes: [dynamics], [[mass]], [[hose]], the drives of its axes and the
/// densities of its shapes, whose meshes are read. Null where it has no [dynamics]. The error is a sentence
/// that names the shape.
tl::expected<std::shared_ptr<const dynamics::Dynamics>, std::string> make_dynamics(
    const machine::Machine& machine, const cell::MeshFiles& files = {});

/// What the peaks of its motors allow; null where they do not limit its accelerations. `dynamics` is its own.
std::shared_ptr<const motion::MoveLimits> make_effort_limits(
    const machine::Machine& machine, std::shared_ptr<const dynamics::Dynamics> dynamics);

}  // namespace gsim::simulation

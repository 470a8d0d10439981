#pragma once

#include <string>

#include <tl/expected.hpp>

#include "geometry/mesh/mesh_file.h"
#include "machine/model/link_shape.h"
#include "motion/dynamics/rigid_body.h"

namespace gsim::cell {

/// The mass of a solid body of even density in the frame of its shape: closed forms, and of a closed mesh the
/// integrals over what its triangles enclose. Reads the mesh. The error is a sentence that names its file:
/// what cannot be read, or where its surface is open.
tl::expected<dynamics::RigidBody, std::string> mass_of(const machine::ShapeForm& form, double density_kg_m3,
                                                       const MeshFiles& files = {});

}  // namespace gsim::cell

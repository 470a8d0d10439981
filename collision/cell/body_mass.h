#pragma once

#include <string>

#include "base/error.h"
#include "geometry/mesh/mesh_file.h"
#include "machine/model/link_shape.h"
#include "motion/dynamics/rigid_body.h"

namespace gsim::cell {

/// Returns the mass of a solid body of even density in the frame of its shape: closed forms, and for a closed
/// mesh the integrals over the volume of its triangles. Reads the mesh. The error is a message that names its
/// file, and what cannot be read or where its surface is open.
Result<dynamics::RigidBody> compute_rigid_body(const machine::ShapeForm& form, double density_kg_m3,
                                               const MeshFiles& files = {});

}  // namespace gsim::cell

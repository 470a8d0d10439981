#pragma once

#include <string>

#include "base/error.h"
#include "collision/cell/cell.h"
#include "geometry/mesh/mesh_file.h"

namespace gsim::cell {

/// Returns the shape that a file describes; reads its mesh. The error is a message that names the mesh file.
Result<Shape> make_shape(const machine::ShapeForm& form, const MeshFiles& files = {});

/// Returns a cell with only the machine's own shapes so far. The error is a message that names the shape with
/// the mesh that cannot be read.
Result<Cell> make_machine_cell(const machine::Machine& machine, const MeshFiles& files = {});

}  // namespace gsim::cell

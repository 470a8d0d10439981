#pragma once

#include <string>

#include <tl/expected.hpp>

#include "collision/cell/cell.h"
#include "geometry/mesh/mesh_file.h"

namespace gsim::cell {

/// The shape that a file describes; reads its mesh. The error is a sentence that names the mesh file.
tl::expected<Shape, std::string> make_shape(const machine::ShapeForm& form, const MeshFiles& files = {});

/// A cell with the machine's own shapes, and with nothing else so far. The error is a sentence that names the
/// shape whose mesh cannot be read.
tl::expected<Cell, std::string> cell_of_machine(const machine::Machine& machine, const MeshFiles& files = {});

}  // namespace gsim::cell

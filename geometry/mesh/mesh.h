#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "base/error.h"

namespace gsim::solid {

/// True if a file is STEP (.step, .stp) or IGES (.iges, .igs), by the extension of its name.
bool is_solid_file(const std::filesystem::path& file);

/// Triangles of surfaces. Their corners are indices of vertices, counter-clockwise seen from outside of a
/// body. Neighbours share vertices.
struct Mesh {
    std::vector<std::array<double, 3>> vertices_mm;
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// Max number of triangles of a mesh.
inline constexpr std::size_t kMaxTriangles = 5'000'000;

/// Max deviation of triangles from the surfaces of a STEP or IGES file, if a file does not give it.
inline constexpr double kMeshTolerance_mm = 0.05;

/// Returns the surfaces of all bodies of a STEP or IGES file as triangles that deviate from them by
/// `tolerance_mm` (greater than 0) at most. Lengths are those of the file's unit, converted to mm. The error
/// is a message that names the file.
Result<Mesh> read_mesh(const std::filesystem::path& file, double tolerance_mm);

}  // namespace gsim::solid

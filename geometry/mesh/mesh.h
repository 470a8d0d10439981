#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <tl/expected.hpp>

namespace gsim::solid {

/// Whether a file is one of STEP (.step, .stp) or IGES (.iges, .igs), by the ending of its name.
bool is_solid_file(const std::filesystem::path& file);

/// Triangles of surfaces; their corners are indices of vertices, counter-clockwise from outside of a body.
/// Neighbours share vertices.
struct Mesh {
    std::vector<std::array<double, 3>> vertices_mm;
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// A mesh cannot have more triangles than this.
inline constexpr std::size_t kMaxTriangles = 5'000'000;

/// How far triangles may be off the surfaces of a STEP or IGES file if a file does not say it.
inline constexpr double kMeshTolerance_mm = 0.05;

/// The surfaces of all bodies of a STEP or IGES file in triangles that are off them by `tolerance_mm`
/// (greater than 0) at most. Lengths are those of the file's unit, in mm. The error is a sentence that names
/// the file.
tl::expected<Mesh, std::string> read_mesh(const std::filesystem::path& file, double tolerance_mm);

}  // namespace gsim::solid

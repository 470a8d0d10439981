#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include "base/os/files.h"
#include "geometry/distance/triangle_mesh.h"
#include "geometry/mesh/mesh.h"

namespace gsim::cell {

/// Reads a surface of triangles: binary STL, ASCII STL, or OBJ by the ending ".obj" of `file_name`. The files
/// know no unit; coordinates times `scale` are mm. A file that is cut off, or holds what is no number, or
/// more than 5 million triangles, or lengths beyond 1e6 mm, is an error: "file: sentence" or "file:line:
/// sentence".
tl::expected<std::shared_ptr<const TriangleMesh>, std::string> read_mesh(std::string_view bytes,
                                                                         std::string_view file_name,
                                                                         double scale);

/// Where meshes are read from.
struct MeshFiles {
    /// The surfaces of a STEP or IGES file as triangles: solid::read_mesh(), which needs a process of its
    /// own, or what stands in for it.
    using ReadSolid = std::function<tl::expected<solid::Mesh, std::string>(const std::filesystem::path& file,
                                                                           double tolerance_mm)>;

    const os::Files& files = os::disk();
    ReadSolid read_solid = solid::read_mesh;
};

/// Reads a file: as read_mesh() does, of at most 512 MiB; or a STEP or IGES file (by its ending
/// .step, .stp, .iges, .igs), whose surfaces become triangles that are off them by `tolerance_mm` at most.
tl::expected<std::shared_ptr<const TriangleMesh>, std::string> load_mesh(
    const std::filesystem::path& path, double scale, double tolerance_mm = solid::kMeshTolerance_mm,
    const MeshFiles& files = {});

}  // namespace gsim::cell

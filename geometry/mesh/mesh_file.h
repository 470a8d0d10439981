#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "base/error.h"
#include "base/os/files.h"
#include "geometry/distance/triangle_mesh.h"
#include "geometry/mesh/mesh.h"

namespace gsim::cell {

/// Reads a surface of triangles: binary STL, ASCII STL, or OBJ by the extension ".obj" of `file_name`. The
/// files have no unit; coordinates times `scale` are mm. A truncated file, a word that is not a number, more
/// than 5 million triangles, or lengths beyond 1e6 mm are an error: "file: message" or "file:line: message".
Result<std::shared_ptr<const TriangleMesh>> read_mesh(std::string_view bytes, std::string_view file_name,
                                                      double scale);

/// Source from which meshes are read.
struct MeshFiles {
    /// Function that returns the surfaces of a STEP or IGES file as triangles: solid::read_mesh(), which
    /// needs a separate process, or its replacement.
    using ReadSolid =
        std::function<Result<solid::Mesh>(const std::filesystem::path& file, double tolerance_mm)>;

    const os::Files& files = os::disk();
    ReadSolid read_solid = solid::read_mesh;
};

/// Reads a file of at most 512 MiB as read_mesh() does. Or reads a STEP or IGES file (by its extension .step,
/// .stp, .iges, .igs) as triangles that deviate from its surfaces by `tolerance_mm` at most.
Result<std::shared_ptr<const TriangleMesh>> load_mesh(const std::filesystem::path& path, double scale,
                                                      double tolerance_mm = solid::kMeshTolerance_mm,
                                                      const MeshFiles& files = {});

}  // namespace gsim::cell

#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include "runtime/cell/triangle_mesh.h"

namespace gsim::cell {

/// Reads a surface of triangles: binary STL, ASCII STL, or OBJ by the ending ".obj" of `file_name`. The files
/// know no unit; coordinates times `scale` are mm. A file that is cut off, or holds what is no number, or
/// more than 5 million triangles, or lengths beyond 1e6 mm, is an error: "file: sentence" or "file:line:
/// sentence".
tl::expected<std::shared_ptr<const TriangleMesh>, std::string> read_mesh(std::string_view bytes,
                                                                         std::string_view file_name,
                                                                         double scale);

/// read_mesh() of a file on disk, of at most 512 MiB.
tl::expected<std::shared_ptr<const TriangleMesh>, std::string> load_mesh(const std::filesystem::path& path,
                                                                         double scale);

}  // namespace gsim::cell

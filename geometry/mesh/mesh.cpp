#include "geometry/mesh/mesh.h"

#include <fmt/format.h>

#include "base/text/letter_case.h"
#include "geometry/mesh/mesh_packet.h"
#include "geometry/mesh/reader_process.h"

namespace gsim::solid {

bool is_solid_file(const std::filesystem::path& file) {
    const std::string extension = text::lower(file.extension().string());
    return extension == ".step" || extension == ".stp" || extension == ".iges" || extension == ".igs";
}

Result<Mesh> read_mesh(const std::filesystem::path& file, double tolerance_mm) {
    return query_reader_as("mesh", file, {fmt::format("{}", tolerance_mm)}, unpack_mesh);
}

}  // namespace gsim::solid

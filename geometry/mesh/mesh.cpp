#include "geometry/mesh/mesh.h"

#include <fmt/format.h>

#include "base/text/letter_case.h"
#include "geometry/mesh/mesh_packet.h"
#include "geometry/mesh/reader_process.h"

namespace gsim::solid {

bool is_solid_file(const std::filesystem::path& file) {
    const std::string ending = text::lower(file.extension().string());
    return ending == ".step" || ending == ".stp" || ending == ".iges" || ending == ".igs";
}

tl::expected<Mesh, std::string> read_mesh(const std::filesystem::path& file, double tolerance_mm) {
    return ask_reader_for("mesh", file, {fmt::format("{}", tolerance_mm)}, take_mesh);
}

}  // namespace gsim::solid

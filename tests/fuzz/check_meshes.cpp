#include <fmt/format.h>

#include "cam/solid/contours_packet.h"
#include "cam/solid/plate_packet.h"
#include "geometry/mesh/mesh_file.h"
#include "geometry/mesh/mesh_packet.h"
#include "tests/fuzz/checks.h"
#include "tests/fuzz/promises.h"

namespace gsim::fuzz {
namespace {

constexpr double kScale = 2;
constexpr double kMeshReach_mm = 1e6;

/// Errors of a binary file have no line.
Outcome check_mesh(std::string_view bytes, const std::string& file) {
    const auto mesh = cell::read_mesh(bytes, file, kScale);
    if (!mesh) {
        if (auto violation = fault_of_sentence(mesh.error().message)) return broken(*std::move(violation));
        if (!mesh.error().message.starts_with(file))
            return broken("an error without its file: " + mesh.error().message);
        return rejected();
    }
    if ((*mesh)->triangle_count() == 0 || (*mesh)->nodes().empty()) return broken("a mesh without triangles");
    for (const Eigen::Vector3d& vertex : (*mesh)->vertices_mm()) {
        if (!vertex.allFinite() || vertex.cwiseAbs().maxCoeff() > kMeshReach_mm)
            return broken(fmt::format("a corner at {} {} {}", vertex.x(), vertex.y(), vertex.z()));
    }
    return accepted();
}

}  // namespace

Outcome check_mesh_stl(std::string_view bytes) {
    return check_mesh(bytes, name_beside(".stl"));
}

Outcome check_mesh_obj(std::string_view text) {
    return check_mesh(text, name_beside(".obj"));
}

Outcome check_solid_packet(std::string_view bytes) {
    solid::PacketReader plate(bytes);
    solid::unpack_plate(plate);
    solid::PacketReader contours(bytes);
    const solid::WallContours walls = solid::unpack_contours(contours);
    if (contours.is_complete()) {
        solid::PacketWriter repeated;
        solid::pack_contours(repeated, walls);
        if (repeated.bytes().size() > bytes.size()) return broken("contours are written in another way");
    }
    solid::PacketReader mesh(bytes);
    const solid::Mesh triangles = solid::unpack_mesh(mesh);
    if (!mesh.is_complete() && !plate.is_complete() && !contours.is_complete()) return rejected();
    if (!mesh.is_complete()) return accepted();
    solid::PacketWriter repeated;
    solid::pack_mesh(repeated, triangles);
    if (!bytes.starts_with(repeated.bytes())) return broken("a mesh is written in another way");
    return accepted();
}

}  // namespace gsim::fuzz

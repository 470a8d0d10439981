#pragma once

#include "geometry/mesh/mesh.h"
#include "geometry/mesh/packet.h"

namespace gsim::solid {

inline void pack_mesh(PacketWriter& packet, const Mesh& mesh) {
    packet.write_all(mesh.vertices_mm);
    packet.write_all(mesh.triangles);
}

inline Mesh unpack_mesh(PacketReader& packet) {
    Mesh mesh;
    mesh.vertices_mm = packet.read_all<std::array<double, 3>>();
    mesh.triangles = packet.read_all<std::array<std::uint32_t, 3>>();
    return mesh;
}

}  // namespace gsim::solid

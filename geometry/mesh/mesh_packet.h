#pragma once

#include "geometry/mesh/mesh.h"
#include "geometry/mesh/packet.h"

namespace gsim::solid {

inline void put_mesh(PacketWriter& packet, const Mesh& mesh) {
    packet.put_all(mesh.vertices_mm);
    packet.put_all(mesh.triangles);
}

inline Mesh take_mesh(PacketReader& packet) {
    Mesh mesh;
    mesh.vertices_mm = packet.get_all<std::array<double, 3>>();
    mesh.triangles = packet.get_all<std::array<std::uint32_t, 3>>();
    return mesh;
}

}  // namespace gsim::solid

#include "cam/solid/contours_packet.h"

namespace gsim::solid {

namespace {

void pack_edge(PacketWriter& packet, const WallEdge& edge) {
    packet.write_text(edge.name);
    packet.write_text(edge.label);
    packet.write(edge.next_surface_mm);
    packet.write_all(edge.points);
}

WallEdge unpack_edge(PacketReader& packet) {
    WallEdge edge;
    edge.name = packet.read_text();
    edge.label = packet.read_text();
    edge.next_surface_mm = packet.read<double>();
    edge.points = packet.read_all<WallPoint>();
    return edge;
}

}  // namespace

void pack_contours(PacketWriter& packet, const WallContours& contours) {
    packet.write(contours.low_mm);
    packet.write(contours.high_mm);
    packet.write(static_cast<std::uint64_t>(contours.contours.size()));
    for (const WallContour& contour : contours.contours) {
        packet.write_text(contour.face);
        packet.write_flag(contour.is_hole);
        packet.write_flag(contour.is_open);
        packet.write(static_cast<std::uint64_t>(contour.edges.size()));
        for (const WallEdge& edge : contour.edges) pack_edge(packet, edge);
    }
    packet.write(static_cast<std::uint64_t>(contours.notes.size()));
    for (const std::string& note : contours.notes) packet.write_text(note);
    packet.write(static_cast<std::uint64_t>(contours.other_edges.size()));
    for (const PartEdge& edge : contours.other_edges) {
        packet.write_text(edge.name);
        packet.write_all(edge.points_mm);
    }
}

WallContours unpack_contours(PacketReader& packet) {
    WallContours contours;
    contours.low_mm = packet.read<Vec3>();
    contours.high_mm = packet.read<Vec3>();
    contours.contours.resize(packet.read_count(1));
    for (WallContour& contour : contours.contours) {
        contour.face = packet.read_text();
        contour.is_hole = packet.read_flag();
        contour.is_open = packet.read_flag();
        contour.edges.resize(packet.read_count(1));
        for (WallEdge& edge : contour.edges) edge = unpack_edge(packet);
    }
    contours.notes.resize(packet.read_count(1));
    for (std::string& note : contours.notes) note = packet.read_text();
    contours.other_edges.resize(packet.read_count(1));
    for (PartEdge& edge : contours.other_edges) {
        edge.name = packet.read_text();
        edge.points_mm = packet.read_all<Vec3>();
    }
    return contours;
}

}  // namespace gsim::solid

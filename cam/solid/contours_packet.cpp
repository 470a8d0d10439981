#include "cam/solid/contours_packet.h"

namespace gsim::solid {

namespace {

void put_edge(PacketWriter& packet, const WallEdge& edge) {
    packet.put_text(edge.name);
    packet.put_text(edge.label);
    packet.put(edge.behind_mm);
    packet.put_all(edge.points);
}

WallEdge take_edge(PacketReader& packet) {
    WallEdge edge;
    edge.name = packet.get_text();
    edge.label = packet.get_text();
    edge.behind_mm = packet.get<double>();
    edge.points = packet.get_all<WallPoint>();
    return edge;
}

}  // namespace

void put_contours(PacketWriter& packet, const WallContours& contours) {
    packet.put(contours.low_mm);
    packet.put(contours.high_mm);
    packet.put(static_cast<std::uint64_t>(contours.contours.size()));
    for (const WallContour& contour : contours.contours) {
        packet.put_text(contour.face);
        packet.put_flag(contour.is_hole);
        packet.put_flag(contour.is_open);
        packet.put(static_cast<std::uint64_t>(contour.edges.size()));
        for (const WallEdge& edge : contour.edges) put_edge(packet, edge);
    }
    packet.put(static_cast<std::uint64_t>(contours.notes.size()));
    for (const std::string& note : contours.notes) packet.put_text(note);
    packet.put(static_cast<std::uint64_t>(contours.other_edges.size()));
    for (const PartEdge& edge : contours.other_edges) {
        packet.put_text(edge.name);
        packet.put_all(edge.points_mm);
    }
}

WallContours take_contours(PacketReader& packet) {
    WallContours contours;
    contours.low_mm = packet.get<Triple>();
    contours.high_mm = packet.get<Triple>();
    contours.contours.resize(packet.get_count(1));
    for (WallContour& contour : contours.contours) {
        contour.face = packet.get_text();
        contour.is_hole = packet.get_flag();
        contour.is_open = packet.get_flag();
        contour.edges.resize(packet.get_count(1));
        for (WallEdge& edge : contour.edges) edge = take_edge(packet);
    }
    contours.notes.resize(packet.get_count(1));
    for (std::string& note : contours.notes) note = packet.get_text();
    contours.other_edges.resize(packet.get_count(1));
    for (PartEdge& edge : contours.other_edges) {
        edge.name = packet.get_text();
        edge.points_mm = packet.get_all<Triple>();
    }
    return contours;
}

}  // namespace gsim::solid

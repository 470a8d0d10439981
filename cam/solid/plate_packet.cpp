#include "cam/solid/plate_packet.h"

namespace gsim::solid {

void put_plate(PacketWriter& packet, const Plate& plate) {
    const drawing::Drawing& drawing = plate.drawing;
    packet.put(plate.thickness_mm);
    packet.put(static_cast<std::uint64_t>(drawing.entities.size()));
    for (const drawing::Entity& entity : drawing.entities) {
        packet.put_text(entity.kind);
        packet.put_text(entity.name);
        packet.put(entity.bevel_deg);
    }
    packet.put(static_cast<std::uint64_t>(drawing.pieces.size()));
    for (const geometry::Contour& piece : drawing.pieces) {
        packet.put_flag(piece.closed);
        packet.put_all(piece.vertices);
    }
    packet.put(static_cast<std::uint64_t>(drawing.notes.size()));
    for (const std::string& note : drawing.notes) packet.put_text(note);
}

Plate take_plate(PacketReader& packet) {
    Plate plate;
    plate.thickness_mm = packet.get<double>();
    plate.drawing.entities.resize(packet.get_count(1));
    for (drawing::Entity& entity : plate.drawing.entities) {
        entity.kind = packet.get_text();
        entity.name = packet.get_text();
        entity.bevel_deg = packet.get<double>();
    }
    plate.drawing.pieces.resize(packet.get_count(1));
    for (geometry::Contour& piece : plate.drawing.pieces) {
        piece.closed = packet.get_flag();
        piece.vertices = packet.get_all<geometry::Vertex>();
    }
    plate.drawing.notes.resize(packet.get_count(1));
    for (std::string& note : plate.drawing.notes) note = packet.get_text();
    return plate;
}

}  // namespace gsim::solid

#include "cam/solid/plate_packet.h"

namespace gsim::solid {

void pack_plate(PacketWriter& packet, const Plate& plate) {
    const drawing::Drawing& drawing = plate.drawing;
    packet.write(plate.thickness_mm);
    packet.write(static_cast<std::uint64_t>(drawing.entities.size()));
    for (const drawing::Entity& entity : drawing.entities) {
        packet.write_text(entity.kind);
        packet.write_text(entity.name);
        packet.write(entity.bevel_deg);
    }
    packet.write(static_cast<std::uint64_t>(drawing.drawn_contours.size()));
    for (const geometry::Contour& drawn_contour : drawing.drawn_contours) {
        packet.write_flag(drawn_contour.closed);
        packet.write_all(drawn_contour.vertices);
    }
    packet.write(static_cast<std::uint64_t>(drawing.notes.size()));
    for (const std::string& note : drawing.notes) packet.write_text(note);
}

Plate unpack_plate(PacketReader& packet) {
    Plate plate;
    plate.thickness_mm = packet.read<double>();
    plate.drawing.entities.resize(packet.read_count(1));
    for (drawing::Entity& entity : plate.drawing.entities) {
        entity.kind = packet.read_text();
        entity.name = packet.read_text();
        entity.bevel_deg = packet.read<double>();
    }
    plate.drawing.drawn_contours.resize(packet.read_count(1));
    for (geometry::Contour& drawn_contour : plate.drawing.drawn_contours) {
        drawn_contour.closed = packet.read_flag();
        drawn_contour.vertices = packet.read_all<geometry::Vertex>();
    }
    plate.drawing.notes.resize(packet.read_count(1));
    for (std::string& note : plate.drawing.notes) note = packet.read_text();
    return plate;
}

}  // namespace gsim::solid

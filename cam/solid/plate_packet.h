#pragma once

#include "cam/solid/plate.h"
#include "geometry/mesh/packet.h"

namespace gsim::solid {

void pack_plate(PacketWriter& packet, const Plate& plate);
Plate unpack_plate(PacketReader& packet);

}  // namespace gsim::solid

#pragma once

#include "cam/solid/plate.h"
#include "geometry/mesh/packet.h"

namespace gsim::solid {

void put_plate(PacketWriter& packet, const Plate& plate);
Plate take_plate(PacketReader& packet);

}  // namespace gsim::solid

#pragma once

#include "cam/solid/packet.h"
#include "cam/solid/plate.h"

namespace gsim::solid {

void put_plate(PacketWriter& packet, const Plate& plate);
Plate take_plate(PacketReader& packet);

}  // namespace gsim::solid

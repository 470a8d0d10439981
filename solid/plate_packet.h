#pragma once

#include "solid/packet.h"
#include "solid/plate.h"

namespace gsim::solid {

void put_plate(PacketWriter& packet, const Plate& plate);
Plate take_plate(PacketReader& packet);

}  // namespace gsim::solid

#pragma once

#include "cam/solid/contours.h"
#include "geometry/mesh/packet.h"

namespace gsim::solid {

void put_contours(PacketWriter& packet, const WallContours& contours);
WallContours take_contours(PacketReader& packet);

}  // namespace gsim::solid

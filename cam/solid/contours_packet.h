#pragma once

#include "cam/solid/contours.h"
#include "geometry/mesh/packet.h"

namespace gsim::solid {

void pack_contours(PacketWriter& packet, const WallContours& contours);
WallContours unpack_contours(PacketReader& packet);

}  // namespace gsim::solid

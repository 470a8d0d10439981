#pragma once

#include "tests/lua_lib/roundtrip/roundtrip_shapes.h"

namespace gsim::roundtrip {

/// Blocks around other ones.
struct Bracket {
    Body begin;
    Block end;
};

/// A random mirror image, scaling or rotation of the 9/Series. In `inside` the planes are left in which arcs
/// stay arcs.
Bracket random_transformation(Scope& inside, Random& random, Values& values);

}  // namespace gsim::roundtrip

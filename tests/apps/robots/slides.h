#pragma once

#include <string>

namespace gsim::apps {

/// Returns a machine file: slides X, Y and Z that are at their speed at once, so that X moves from 0 at 100
/// mm/s with F6000. It has no bodies.
inline std::string slides(const std::string& name) {
    return "[machine]\nname = \"" + name + "\"\ninverse = \"none\"" + R"(
[[axis]]
letter = "X"
kind = "linear"
max_speed_mm_s = 1000.0
direction = "x"
[[axis]]
letter = "Y"
kind = "linear"
max_speed_mm_s = 1000.0
direction = "y"
[[axis]]
letter = "Z"
kind = "linear"
max_speed_mm_s = 1000.0
direction = "z"
)";
}

}  // namespace gsim::apps

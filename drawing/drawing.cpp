#include "drawing/drawing.h"

#include <fmt/format.h>

namespace gsim::drawing {

std::string shown(const Entity& entity) {
    if (entity.name.empty()) return fmt::format("{} at line {}", entity.kind, entity.line);
    return fmt::format("{} {} at line {}", entity.kind, entity.name, entity.line);
}

}  // namespace gsim::drawing

#include "cam/drawing/drawing.h"

#include <fmt/format.h>

namespace gsim::drawing {

std::string display_text(const Entity& entity) {
    std::string text = entity.kind;
    if (!entity.name.empty()) text += fmt::format(" {}", entity.name);
    if (entity.line > 0) text += fmt::format(" at line {}", entity.line);
    return text;
}

}  // namespace gsim::drawing

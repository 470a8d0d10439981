#include "studio/engine/contour_keys.h"

namespace gsim::studio {

using nlohmann::json;

namespace {

constexpr double kMaxCoordinate_mm = 1e6;

}  // namespace

void unpack_contours(KeyReader& keys, std::optional<engine::SurfaceCuttingOptions>& surface) {
    const json* object_json = keys.object("contours");
    if (object_json == nullptr) return;
    constexpr std::array kKinds{"holes", "outlines", "all", "edges"};
    constexpr std::array kAxes{"wall", "normal"};
    engine::SurfaceCuttingOptions& options = surface.emplace();
    KeyReader parameters(*object_json, "contours");
    std::optional<std::size_t> kind, side, axis;
    std::optional<int> bridges;
    parameters.word("kind", kKinds, kind);
    parameters.word("side", kViewDirections, side);
    parameters.texts("faces", options.contours.faces);
    parameters.texts("edges", options.contours.edges);
    parameters.word("axis", kAxes, axis);
    parameters.number("tilt_angle_deg", -80, 80, options.tilt_deg);
    parameters.number("lead_angle_deg", -60, 60, options.lead_angle_deg);
    parameters.number("max_tilt_deg", 0, 85, options.max_tilt_deg);
    parameters.read_integer("bridges", 0, 1000, bridges);
    parameters.number("bridge_mm", 0, 100, options.bridge_mm);
    parameters.point("start_mm", -kMaxCoordinate_mm, kMaxCoordinate_mm, options.start_mm);
    if (kind) options.contours.kind = kKinds[*kind];
    if (side) options.contours.side = kViewDirections[*side];
    if (axis) options.contours.along_walls = *axis == 0;
    options.bridges = bridges.value_or(0);
    if (auto read = parameters.end(); !read) keys.add_error(read.error().message);
}

}  // namespace gsim::studio

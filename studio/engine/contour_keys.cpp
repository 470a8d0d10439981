#include "studio/engine/contour_keys.h"

namespace gsim::studio {

using nlohmann::json;

namespace {

constexpr double kMost_mm = 1e6;

}  // namespace

void take_contours(Keys& keys, std::optional<engine::SurfaceChoice>& surface) {
    const json* given = keys.object("contours");
    if (given == nullptr) return;
    constexpr std::array kKinds{"holes", "outlines", "all", "edges"};
    constexpr std::array kAxes{"wall", "normal"};
    engine::SurfaceChoice& choice = surface.emplace();
    Keys own(*given, "contours");
    std::optional<std::size_t> kind, side, axis;
    std::optional<int> bridges;
    own.word("kind", kKinds, kind);
    own.word("side", kContourSides, side);
    own.texts("faces", choice.contours.faces);
    own.texts("edges", choice.contours.edges);
    own.word("axis", kAxes, axis);
    own.number("lean_deg", -80, 80, choice.lean_deg);
    own.number("tilt_deg", -60, 60, choice.tilt_deg);
    own.number("max_lean_deg", 0, 85, choice.max_lean_deg);
    own.whole("bridges", 0, 1000, bridges);
    own.number("bridge_mm", 0, 100, choice.bridge_mm);
    own.point("start_mm", -kMost_mm, kMost_mm, choice.start_mm);
    if (kind) choice.contours.kind = kKinds[*kind];
    if (side) choice.contours.side = kContourSides[*side];
    if (axis) choice.contours.along_walls = *axis == 0;
    choice.bridges = bridges.value_or(0);
    if (auto read = own.end(); !read) keys.fault(read.error());
}

}  // namespace gsim::studio

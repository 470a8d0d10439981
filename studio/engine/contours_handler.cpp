// Lists the contours of a part that could be cut, for a user to choose from.

#include <string>
#include <vector>

#include "engine/contour_list.h"
#include "studio/engine/contour_keys.h"
#include "studio/engine/message.h"
#include "studio/engine/request_handlers.h"

namespace gsim::studio {

using nlohmann::json;

namespace {

nlohmann::ordered_json contour_json(const engine::ListedContour& contour) {
    return {{"face", contour.face},           {"is_hole", contour.is_hole},
            {"is_open", contour.is_open},     {"edges", contour.edges},
            {"length_mm", contour.length_mm}, {"depth_mm", contour.depth_mm},
            {"tilt_deg", contour.tilt_deg},   {"points", contour.polyline_mm.size()}};
}

void send_contours(const engine::ContourList& list, const Post& post) {
    Message message("contours");
    auto& contours = message.header()["contours"] = nlohmann::ordered_json::array();
    std::vector<double> lines_mm;
    for (const engine::ListedContour& contour : list.contours) {
        contours.push_back(contour_json(contour));
        for (const auto& row : contour.polyline_mm) lines_mm.insert(lines_mm.end(), row.begin(), row.end());
    }
    message.header()["notes"] = list.notes;
    message.add("lines", lines_mm);
    post(message.bytes());
}

}  // namespace

VoidResult handle_contours(const json& parameters, const engine::Request& request, const Post& post) {
    std::string part;
    engine::ContourSelection selection;
    std::optional<engine::SurfaceCuttingOptions> surface;
    KeyReader keys(parameters, "contours of a part");
    keys.required_text("drawing", part);
    keys.number("curve_tolerance_mm", 1e-5, 10, selection.tolerance_mm);
    keys.require("contours");
    unpack_contours(keys, surface);
    if (auto read = finish_keys(keys); !read) return read;
    const double tolerance_mm = selection.tolerance_mm;
    selection = surface.value_or(engine::SurfaceCuttingOptions{}).contours;
    selection.tolerance_mm = tolerance_mm;
    const auto list = engine::list_contours(request.host, part, selection);
    if (!list) return tl::unexpected(list.error());
    send_contours(*list, post);
    return {};
}

}  // namespace gsim::studio

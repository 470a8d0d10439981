#include "engine/contour_list.h"

#include <utility>

#include "engine/src/conversions.h"
#include "engine/src/drawing/surface_input.h"
#include "engine/src/guard_exceptions.h"
#include "engine/src/host_names.h"

namespace gsim::engine {

namespace {

using text::DiagnosticKind;

std::vector<std::array<double, 3>> contour_points(const solid::WallContour& contour) {
    std::vector<std::array<double, 3>> polyline_mm;
    for (const solid::WallEdge& edge : contour.edges) {
        // The end of an edge is the beginning of the next.
        if (!polyline_mm.empty()) polyline_mm.pop_back();
        for (const solid::WallPoint& point : edge.points) polyline_mm.push_back(point.position_mm);
    }
    return polyline_mm;
}

ListedContour listed(const solid::WallContour& contour) {
    const script::ContourDescription facts = describe_contour(contour);
    ListedContour each{.face = facts.face,
                       .is_hole = facts.is_hole,
                       .is_open = facts.is_open,
                       .length_mm = facts.length_mm,
                       .depth_mm = facts.depth_mm,
                       .tilt_deg = facts.tilt_deg,
                       .polyline_mm = contour_points(contour)};
    for (const solid::WallEdge& edge : contour.edges) each.edges.push_back(edge.label);
    return each;
}

}  // namespace

tl::expected<ContourList, Error> list_contours(const Host& host, const std::string& part,
                                               const ContourSelection& selection) {
    return guard_exceptions([&]() -> tl::expected<ContourList, Error> {
        const auto file = resolve_name(host, NameKind::sample, part);
        if (!file) return tl::unexpected(make_error(DiagnosticKind::input_file, file.error()));
        auto read = read_part_contours(host, *file, selection);
        if (!read) return tl::unexpected(make_error(DiagnosticKind::input_file, read.error(), part));
        ContourList list{.notes = std::move(read->notes)};
        for (const solid::WallContour& contour : read->contours) list.contours.push_back(listed(contour));
        return list;
    });
}

}  // namespace gsim::engine

#include "engine/contour_list.h"

#include <utility>

#include "engine/src/drawing/surface_input.h"
#include "engine/src/guarded.h"
#include "engine/src/host_names.h"
#include "engine/src/values.h"

namespace gsim::engine {

namespace {

using text::DiagnosticKind;

std::vector<std::array<double, 3>> line_of(const solid::WallContour& contour) {
    std::vector<std::array<double, 3>> line_mm;
    for (const solid::WallEdge& edge : contour.edges) {
        // The end of an edge is the beginning of the next.
        if (!line_mm.empty()) line_mm.pop_back();
        for (const solid::WallPoint& point : edge.points) line_mm.push_back(point.position_mm);
    }
    return line_mm;
}

ListedContour listed(const solid::WallContour& contour) {
    const script::ContourFacts facts = facts_of(contour);
    ListedContour each{.face = facts.face,
                       .is_hole = facts.is_hole,
                       .is_open = facts.is_open,
                       .length_mm = facts.length_mm,
                       .depth_mm = facts.depth_mm,
                       .lean_deg = facts.lean_deg,
                       .line_mm = line_of(contour)};
    for (const solid::WallEdge& edge : contour.edges) each.edges.push_back(edge.label);
    return each;
}

}  // namespace

tl::expected<ContourList, Failure> list_contours(const Host& host, const std::string& part,
                                                 const ContourChoice& choice) {
    return guarded([&]() -> tl::expected<ContourList, Failure> {
        const auto file = find_name(host, NameKind::sample, part);
        if (!file) return tl::unexpected(failure_of(DiagnosticKind::input_file, file.error()));
        auto read = read_part_contours(host, *file, choice);
        if (!read) return tl::unexpected(failure_of(DiagnosticKind::input_file, read.error(), part));
        ContourList list{.notes = std::move(read->notes)};
        for (const solid::WallContour& contour : read->contours) list.contours.push_back(listed(contour));
        return list;
    });
}

}  // namespace gsim::engine

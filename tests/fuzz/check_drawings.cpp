#include <cmath>

#include <fmt/format.h>

#include "cam/cutting/autopath.h"
#include "cam/drawing/dxf_reader.h"
#include "cam/drawing/svg_reader.h"
#include "geometry/planar/chain.h"
#include "tests/fuzz/checks.h"
#include "tests/fuzz/promises.h"
#include "toolpath/model/validate.h"

namespace gsim::fuzz {
namespace {

using drawing::Drawing;

constexpr double kRounding = 1e-9;
/// A path round this number of edges takes milliseconds.
constexpr std::size_t kMostEdges = 200;

constexpr double kKerf_mm = 1;
constexpr double kSpeed_mm_min = 600;

std::size_t edges_of(const Drawing& drawing) {
    std::size_t edges = 0;
    for (const geometry::Contour& drawn_contour : drawing.drawn_contours) edges += drawn_contour.edges();
    return edges;
}

std::optional<std::string> fault_of_vertex(const Drawing& drawing, const geometry::Vertex& vertex) {
    if (!is_finite(vertex.position)) return "a corner is nowhere";
    const double farthest_mm = std::max(std::abs(vertex.position.x), std::abs(vertex.position.y));
    if (farthest_mm > 2 * drawing::kMaxCoordinate_mm)
        return fmt::format("a corner is {} mm away", farthest_mm);
    if (!(std::abs(vertex.bulge) <= 1 + kRounding))
        return fmt::format("an arc has a bulge of {}", vertex.bulge);
    if (vertex.source >= drawing.entities.size()) return "an edge comes from no entity";
    return std::nullopt;
}

std::optional<std::string> drawing_error(const Drawing& drawing) {
    if (edges_of(drawing) > drawing::kMaxEdges) return "more edges than a drawing can have";
    for (const geometry::Contour& drawn_contour : drawing.drawn_contours) {
        for (const geometry::Vertex& vertex : drawn_contour.vertices) {
            if (auto violation = fault_of_vertex(drawing, vertex)) return violation;
        }
    }
    return std::nullopt;
}

/// An error begins with its line.
Outcome refused_drawing(const std::string& error) {
    if (auto violation = fault_of_sentence(error)) return broken(*std::move(violation));
    if (!error.starts_with("line ")) return broken("an error without its line: " + error);
    return rejected();
}

/// Accepted are drawings with a closed contour.
Outcome outcome_of_drawing(const Result<Drawing>& drawing) {
    if (!drawing) return refused_drawing(drawing.error().message);
    if (auto violation = drawing_error(*drawing)) return broken(*std::move(violation));
    constexpr double kJoinTolerance_mm = 0.01;
    const geometry::ChainResult chains = geometry::chain(drawing->drawn_contours, kJoinTolerance_mm);
    return chains.closed.empty() ? rejected() : accepted();
}

/// Checks messages on separate lines.
std::optional<std::string> fault_of_list(std::string_view error) {
    while (true) {
        const std::size_t end = std::min(error.find('\n'), error.size());
        if (auto violation = fault_of_sentence(error.substr(0, end))) return violation;
        if (end == error.size()) return std::nullopt;
        error.remove_prefix(end + 1);
    }
}

}  // namespace

Outcome check_dxf(std::string_view text) {
    return outcome_of_drawing(drawing::read_dxf(text, {}));
}

Outcome check_svg(std::string_view text) {
    return outcome_of_drawing(drawing::read_svg(text, {}));
}

Outcome check_autopath(std::string_view svg) {
    auto drawing = drawing::read_svg(svg, {});
    if (!drawing || edges_of(*drawing) > kMostEdges) return rejected();
    cutting::CutRules rules;
    rules.kerf_mm = kKerf_mm;
    rules.speed_mm_min = kSpeed_mm_min;
    rules.pierce_s = 1;
    const auto path = cutting::autopath(*std::move(drawing), rules, {});
    if (!path) return {.accepted = false, .broken = fault_of_list(path.error().message)};
    if (const auto violation = path::validate(path->program)) return broken(violation->message);
    const cutting::CutSummary& summary = path->summary;
    if (!std::isfinite(summary.cut_mm) || !std::isfinite(summary.travel_mm) || !std::isfinite(summary.cut_s))
        return broken("a length of the cut is not finite");
    if (summary.pierces == 0) return broken("a path that cuts nothing");
    return accepted();
}

}  // namespace gsim::fuzz

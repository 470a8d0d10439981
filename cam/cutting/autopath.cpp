#include "cam/cutting/autopath.h"

#include <algorithm>

#include <fmt/format.h>

#include "cam/cutting/feeds.h"
#include "cam/cutting/order.h"
#include "cam/cutting/tour.h"
#include "toolpath/model/validate.h"

namespace gsim::cutting {

namespace {

constexpr double kDefaultLeadKerfs = 3;

double joint_travel(const std::vector<Cut>& cuts, const std::vector<std::size_t>& order,
                    geometry::Point start) {
    std::vector<Stop> stops;
    stops.reserve(cuts.size());
    for (const Cut& cut : cuts) stops.push_back({cut.pierce(), cut.end()});
    return tour_length_mm(stops, order, start, {});
}

void add_edge_totals(const geometry::Edge& edge, double feed_mm_min, CutSummary& summary) {
    const double mm = length_mm(edge);
    summary.cut_mm += mm;
    summary.cut_s += 60 * mm / feed_mm_min;
}

CutSummary summarize_cuts(const Layout& layout, const std::vector<Cut>& cuts, const CutRules& rules) {
    CutSummary summary;
    summary.outlines = layout.outlines.size();
    summary.pierces = cuts.size();
    for (const Cut& cut : cuts) {
        if (!cut.lead_in) ++summary.without_leads;
        for (const auto& lead : {cut.lead_in, cut.lead_out}) {
            if (lead) add_edge_totals(*lead, edge_feed_mm_min(*lead, rules), summary);
        }
        for (const FeedSegment& edge : assign_feeds(cut.loop, rules))
            add_edge_totals(edge.edge, edge.feed_mm_min, summary);
    }
    summary.slowdown_s = summary.cut_s - 60 * summary.cut_mm / rules.speed_mm_min;
    return summary;
}

}  // namespace

Result<Autopath> autopath(drawing::Drawing drawing, const CutRules& rules, const AutopathOptions& options) {
    std::vector<double> bevels_deg;
    bevels_deg.reserve(drawing.entities.size());
    for (const drawing::Entity& entity : drawing.entities) bevels_deg.push_back(entity.bevel_deg);
    Result<Layout> layout = make_layout(std::move(drawing), {rules.kerf_mm, options.gap_mm});
    if (!layout) return tl::unexpected(std::move(layout.error()));
    const double lead_mm = options.lead_mm > 0 ? options.lead_mm : kDefaultLeadKerfs * rules.kerf_mm;
    const std::vector<Cut> cuts = add_leads(*layout, rules.kerf_mm, lead_mm);
    const std::vector<std::size_t> order = cutting_order(*layout, cuts, options.start_mm);
    CutProgram program_parts = cut_program(cuts, order, rules, bevels_deg, options.program);
    Autopath result{std::move(program_parts.program), summarize_cuts(*layout, cuts, rules),
                    std::move(layout->notes)};
    result.summary.dynamic_pierces = program_parts.dynamic_pierces;
    result.summary.reorientation_s = program_parts.reorientation_s;
    result.summary.cut_s += program_parts.reorientation_s;
    if (rules.taper_compensation_deg) {
        CutRules uncompensated_rules = rules;
        uncompensated_rules.taper_compensation_deg = {};
        result.summary.taper_compensation_s =
            program_parts.reorientation_s -
            cut_program(cuts, order, uncompensated_rules, bevels_deg, options.program).reorientation_s;
    }
    result.summary.travel_mm = joint_travel(cuts, order, options.start_mm);
    if (result.summary.without_leads > 0) {
        result.notes.push_back(
            fmt::format("{} contours have no room for lead-ins: the jet pierces on the contour",
                        result.summary.without_leads));
    }
    if (rules.dynamic_pierce_s && program_parts.dynamic_pierces < cuts.size()) {
        result.notes.push_back(
            fmt::format("{} pierces have no lead-in to move on: the nozzle dwells for {:.4g} s",
                        cuts.size() - program_parts.dynamic_pierces, rules.pierce_s));
    }
    if (const auto error = path::validate(result.program)) return tl::unexpected(error->message);
    return result;
}

}  // namespace gsim::cutting

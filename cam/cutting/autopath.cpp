#include "cam/cutting/autopath.h"

#include <algorithm>

#include <fmt/format.h>

#include "cam/cutting/feeds.h"
#include "cam/cutting/order.h"
#include "cam/cutting/tour.h"
#include "toolpath/model/validate.h"

namespace gsim::cutting {

namespace {

constexpr double kLeadKerfs = 3;

double travel_of(const std::vector<Cut>& cuts, const std::vector<std::size_t>& order, geometry::Point start) {
    std::vector<Stop> stops;
    stops.reserve(cuts.size());
    for (const Cut& cut : cuts) stops.push_back({cut.pierce(), cut.end()});
    return tour_length_mm(stops, order, start, {});
}

void count_edge(const geometry::Edge& edge, double feed_mm_min, CutSummary& summary) {
    const double mm = length_mm(edge);
    summary.cut_mm += mm;
    summary.cut_s += 60 * mm / feed_mm_min;
}

CutSummary summary_of(const Layout& layout, const std::vector<Cut>& cuts, const CutRules& rules) {
    CutSummary summary;
    summary.outlines = layout.outlines.size();
    summary.pierces = cuts.size();
    for (const Cut& cut : cuts) {
        if (!cut.lead_in) ++summary.without_leads;
        for (const auto& lead : {cut.lead_in, cut.lead_out}) {
            if (lead) count_edge(*lead, feed_on_mm_min(*lead, rules), summary);
        }
        for (const FedEdge& edge : with_feeds(cut.loop, rules))
            count_edge(edge.edge, edge.feed_mm_min, summary);
    }
    summary.slower_s = summary.cut_s - 60 * summary.cut_mm / rules.speed_mm_min;
    return summary;
}

}  // namespace

tl::expected<Autopath, std::string> autopath(drawing::Drawing drawing, const CutRules& rules,
                                             const AutopathOptions& options) {
    std::vector<double> bevels_deg;
    bevels_deg.reserve(drawing.entities.size());
    for (const drawing::Entity& entity : drawing.entities) bevels_deg.push_back(entity.bevel_deg);
    tl::expected<Layout, std::string> layout = lay_out(std::move(drawing), {rules.kerf_mm, options.gap_mm});
    if (!layout) return tl::unexpected(std::move(layout.error()));
    const double lead_mm = options.lead_mm > 0 ? options.lead_mm : kLeadKerfs * rules.kerf_mm;
    const std::vector<Cut> cuts = add_leads(*layout, rules.kerf_mm, lead_mm);
    const std::vector<std::size_t> order = cutting_order(*layout, cuts, options.start_mm);
    CutProgram made = cut_program(cuts, order, rules, bevels_deg, options.program);
    Autopath result{std::move(made.program), summary_of(*layout, cuts, rules), std::move(layout->notes)};
    result.summary.moving_pierces = made.moving_pierces;
    result.summary.turning_s = made.turning_s;
    result.summary.cut_s += made.turning_s;
    if (rules.straightening_lean_deg) {
        CutRules with_taper = rules;
        with_taper.straightening_lean_deg = {};
        result.summary.straightening_s =
            made.turning_s - cut_program(cuts, order, with_taper, bevels_deg, options.program).turning_s;
    }
    result.summary.travel_mm = travel_of(cuts, order, options.start_mm);
    if (result.summary.without_leads > 0) {
        result.notes.push_back(
            fmt::format("{} contours have no room for leads: the jet pierces on the contour",
                        result.summary.without_leads));
    }
    if (rules.moving_pierce_s && made.moving_pierces < cuts.size()) {
        result.notes.push_back(
            fmt::format("{} pierces have no lead to move on: the nozzle rests, for {:.4g} s",
                        cuts.size() - made.moving_pierces, rules.pierce_s));
    }
    if (const auto fault = path::validate(result.program)) return tl::unexpected(fault->sentence);
    return result;
}

}  // namespace gsim::cutting

#include "cam/surface/surface_path.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cam/surface/corner_zones.h"
#include "cam/surface/near_edges.h"
#include "cam/surface/surface_lead.h"
#include "cam/surface/surface_program.h"
#include "cam/surface/upright.h"
#include "toolpath/model/validate.h"

namespace gsim::surface {

namespace {

using Fault = tl::unexpected<std::string>;

constexpr double kLeadKerfs = 3;
constexpr double kTold_mm = 0.02;     // of material removed or left at a lower edge
constexpr double kInto_mm = 0.03;     // how far a jet may come into an edge
constexpr double kWallTolerance = 3;  // factor of the wall's lower end, relative to the TCP

// Sorts holes first, outlines last, and within each the nearest next one.
std::vector<SurfaceCut> in_order(std::vector<SurfaceCut> cuts, const JetShape& jet, Vector at) {
    std::vector<SurfaceCut> ordered;
    while (!cuts.empty()) {
        const auto cost = [&](const SurfaceCut& cut) {
            const int rank = cut.way.is_hole ? 0 : cut.way.is_open ? 1 : 2;
            return std::pair(rank, (cut.pierce(jet) - at).norm());
        };
        const auto next = std::min_element(cuts.begin(), cuts.end(),
                                           [&](const auto& a, const auto& b) { return cost(a) < cost(b); });
        at = next->end(jet);
        ordered.push_back(std::move(*next));
        cuts.erase(next);
    }
    return ordered;
}

class PathMaker {
  public:
    PathMaker(const solid::WallContours& part, const cutting::CutRules& rules, const SurfaceOptions& options)
        : part_(part), rules_(rules), options_(options), jet_{rules.kerf_mm, options.cut_height_mm} {}

    tl::expected<cutting::Autopath, std::string> run() {
        std::vector<JetWay> ways;
        for (const solid::WallContour& contour : part_.contours) {
            auto way = jet_way(contour, jet_, options_.jet);
            if (!way) return Fault(way.error());
            ways.push_back(*std::move(way));
        }
        const NearEdges edges(part_.contours, jet_, WallEnd::upper, part_.other_edges);
        for (const JetWay& way : ways) {
            if (auto good = check(way, edges); !good) return Fault(good.error());
        }
        if (options_.jet.touches_both()) {
            tell_taken(ways);
            tell_low_corners(ways);
        }
        std::vector<SurfaceCut> cuts;
        for (const JetWay& way : ways) {
            SurfaceCut cut{way, std::nullopt, {}};
            cut.leads = find_leads(cut.way, jet_, edges, lead_mm());
            mark_corners(cut.way.points, jet_, rules_.feed_in_corner_mm_min ? rules_.corner_zone_mm : 0);
            settle_upright(cut.way.points);
            cut.pieces = pieces_between(cut.way.points, options_.bridges, rules_.kerf_mm);
            if (cut.pieces.empty()) {
                return Fault(fmt::format("{} has no room for {} bridges of {:g} mm", way.name,
                                         options_.bridges.count, options_.bridges.width_mm));
            }
            cuts.push_back(std::move(cut));
        }
        const Vector start = options_.start_mm.value_or(Vector::Zero()) - options_.origin_mm;
        return written(in_order(std::move(cuts), jet_, start));
    }

  private:
    double lead_mm() const { return options_.lead_mm > 0 ? options_.lead_mm : kLeadKerfs * rules_.kerf_mm; }

    tl::expected<void, std::string> check(const JetWay& way, const NearEdges& edges) const {
        for (const JetPoint& at : way.points) {
            const auto found = edges.nearest(middle_of(at, jet_), at.axis, at.depth_mm);
            const double into_mm = rules_.kerf_mm / 2 - found.distance_mm;
            if (into_mm <= kInto_mm) continue;
            return Fault(fmt::format("{} cannot be cut: at {} the jet would go {:.3g} mm into {} at {}",
                                     way.edges[at.edge], shown(at.edge_mm), into_mm, found.edge,
                                     shown(found.place)));
        }
        return {};
    }

    tl::expected<cutting::Autopath, std::string> written(std::vector<SurfaceCut> cuts) const {
        SurfaceProgramOptions options;
        options.name = options_.name;
        options.jet = jet_;
        options.tolerance = {options_.tolerance_mm, kWallTolerance * options_.tolerance_mm};
        options.safe_height_mm = options_.safe_height_mm;
        options.part_top_mm = part_.high_mm[2];
        options.origin_mm = options_.origin_mm;
        options.start_mm = options_.start_mm;
        cutting::Autopath made;
        made.program = surface_program(cuts, rules_, options, made.summary);
        made.cuts.emplace_back();
        for (const SurfaceCut& cut : cuts) made.cuts.push_back(cut.way.name);
        made.notes = part_.notes;
        tell_behind(made.notes);
        made.notes.insert(made.notes.end(), notes_.begin(), notes_.end());
        if (made.summary.without_leads > 0) {
            made.notes.push_back(
                fmt::format("{} contours have no room for leads: the jet pierces on the contour",
                            made.summary.without_leads));
        }
        if (const auto fault = path::validate(made.program)) return Fault(fault->sentence);
        return made;
    }

    void tell_behind(std::vector<std::string>& notes) const {
        for (const solid::WallContour& contour : part_.contours) {
            double nearest = 0;
            const solid::WallEdge* at = nullptr;
            for (const solid::WallEdge& edge : contour.edges) {
                if (edge.behind_mm <= 0 || (at != nullptr && edge.behind_mm >= nearest)) continue;
                nearest = edge.behind_mm;
                at = &edge;
            }
            if (at == nullptr) continue;
            notes.push_back(fmt::format("behind {} of {} the jet meets the part again, {:.4g} mm on",
                                        at->name, contour.face, nearest));
        }
    }

    // A jet that touches both edges of a wall may cut into a lower edge that is curved more tightly than its
    // width.
    void tell_taken(const std::vector<JetWay>& ways) {
        const NearEdges edges(part_.contours, jet_, WallEnd::lower);
        double most_mm = kTold_mm;
        NearEdges::Nearest most;
        for (const JetWay& way : ways) {
            for (const JetPoint& at : way.points) {
                const auto found = edges.nearest(low_middle_of(at, jet_), at.axis, at.depth_mm);
                if (rules_.kerf_mm / 2 - found.distance_mm <= most_mm) continue;
                most_mm = rules_.kerf_mm / 2 - found.distance_mm;
                most = found;
            }
        }
        if (most.edge.empty()) return;
        notes_.push_back(
            fmt::format("at lower edges of walls the jet takes up to {:.2g} mm more: below {} at {}", most_mm,
                        most.edge, shown(most.place)));
    }

    void tell_low_corners(const std::vector<JetWay>& ways) {
        std::size_t count = 0;
        LowCorner most;
        std::string edge;
        for (const JetWay& way : ways) {
            for (const LowCorner& corner : way.low_corners) {
                if (corner.stays_mm <= kTold_mm) continue;
                ++count;
                if (corner.stays_mm <= most.stays_mm) continue;
                most = corner;
                edge = way.edges[corner.edge];
            }
        }
        if (count == 0) return;
        notes_.push_back(
            fmt::format("{} corners of lower edges are narrower than the jet: material stays in them, up to "
                        "{:.2g} mm at {}, "
                        "below {}, where the lower edge turns by {:.0f} deg",
                        count, most.stays_mm, shown(most.place_mm), edge, most.turn_deg));
    }

    const solid::WallContours& part_;
    const cutting::CutRules& rules_;
    const SurfaceOptions& options_;
    JetShape jet_;
    std::vector<std::string> notes_;
};

}  // namespace

tl::expected<cutting::Autopath, std::string> surface_path(const solid::WallContours& part,
                                                          const cutting::CutRules& rules,
                                                          const SurfaceOptions& options) {
    return PathMaker(part, rules, options).run();
}

}  // namespace gsim::surface

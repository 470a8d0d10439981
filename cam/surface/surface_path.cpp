#include "cam/surface/surface_path.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cam/surface/corner_zones.h"
#include "cam/surface/edge_proximity.h"
#include "cam/surface/surface_lead.h"
#include "cam/surface/surface_program.h"
#include "cam/surface/vertical_points.h"
#include "toolpath/model/validate.h"

namespace gsim::surface {

namespace {

constexpr double kDefaultLeadKerfs = 3;
constexpr double kReportThreshold_mm = 0.02;  // of material removed or left at a lower edge
constexpr double kMaxGouge_mm = 0.03;         // how far a jet may come into an edge
constexpr double kWallToleranceFactor = 3;    // factor of the wall's lower end, relative to the TCP

// Sorts holes first, outlines last, and within each the nearest next one.
std::vector<SurfaceCut> sorted_cuts(std::vector<SurfaceCut> cuts, const JetShape& jet, Vector at) {
    std::vector<SurfaceCut> ordered;
    while (!cuts.empty()) {
        const auto cost = [&](const SurfaceCut& cut) {
            const int rank = cut.jet_path.is_hole ? 0 : cut.jet_path.is_open ? 1 : 2;
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

class SurfacePathBuilder {
  public:
    SurfacePathBuilder(const solid::WallContours& part, const cutting::CutRules& rules,
                       const SurfaceOptions& options)
        : part_(part), rules_(rules), options_(options), jet_{rules.kerf_mm, options.cut_height_mm} {}

    Result<cutting::Autopath> run() {
        std::vector<JetPath> paths;
        for (const solid::WallContour& contour : part_.contours) {
            auto path = jet_path(contour, jet_, options_.jet);
            if (!path) return Unexpected(path.error());
            paths.push_back(*std::move(path));
        }
        const EdgeProximity edges(part_.contours, jet_, WallEnd::upper, part_.other_edges);
        for (const JetPath& jet_path : paths) {
            if (auto checked = check(jet_path, edges); !checked) return Unexpected(checked.error());
        }
        if (options_.jet.follows_both_edges()) {
            report_lower_gouges(paths);
            report_lower_corners(paths);
        }
        std::vector<SurfaceCut> cuts;
        for (const JetPath& jet_path : paths) {
            SurfaceCut cut{jet_path, std::nullopt, {}};
            cut.leads = find_leads(cut.jet_path, jet_, edges, lead_mm());
            mark_corners(cut.jet_path.points, jet_, rules_.feed_in_corner_mm_min ? rules_.corner_zone_mm : 0);
            split_vertical_points(cut.jet_path.points);
            cut.parts = split_at_bridges(cut.jet_path.points, options_.bridges, rules_.kerf_mm);
            if (cut.parts.empty()) {
                return Unexpected(fmt::format("{} has no room for {} bridges of {:g} mm", jet_path.name,
                                              options_.bridges.count, options_.bridges.width_mm));
            }
            cuts.push_back(std::move(cut));
        }
        const Vector start = options_.start_mm.value_or(Vector::Zero()) - options_.origin_mm;
        return written(sorted_cuts(std::move(cuts), jet_, start));
    }

  private:
    double lead_mm() const {
        return options_.lead_mm > 0 ? options_.lead_mm : kDefaultLeadKerfs * rules_.kerf_mm;
    }

    Result<void> check(const JetPath& jet_path, const EdgeProximity& edges) const {
        for (const JetPoint& at : jet_path.points) {
            const auto found = edges.nearest(jet_center(at, jet_), at.axis, at.depth_mm);
            const double gouge_mm = rules_.kerf_mm / 2 - found.distance_mm;
            if (gouge_mm <= kMaxGouge_mm) continue;
            return Unexpected(fmt::format("{} cannot be cut: at {} the jet would cut {:.3g} mm into {} at {}",
                                          jet_path.edges[at.edge], display_text(at.edge_mm), gouge_mm,
                                          found.edge, display_text(found.position)));
        }
        return {};
    }

    Result<cutting::Autopath> written(std::vector<SurfaceCut> cuts) const {
        SurfaceProgramOptions options;
        options.name = options_.name;
        options.jet = jet_;
        options.tolerance = {options_.tolerance_mm, kWallToleranceFactor * options_.tolerance_mm};
        options.safe_height_mm = options_.safe_height_mm;
        options.part_top_mm = part_.high_mm[2];
        options.origin_mm = options_.origin_mm;
        options.start_mm = options_.start_mm;
        cutting::Autopath autopath;
        autopath.program = surface_program(cuts, rules_, options, autopath.summary);
        autopath.cuts.emplace_back();
        for (const SurfaceCut& cut : cuts) autopath.cuts.push_back(cut.jet_path.name);
        autopath.notes = part_.notes;
        report_next_surfaces(autopath.notes);
        autopath.notes.insert(autopath.notes.end(), notes_.begin(), notes_.end());
        if (autopath.summary.without_leads > 0) {
            autopath.notes.push_back(
                fmt::format("{} contours have no room for lead-ins: the jet pierces on the contour",
                            autopath.summary.without_leads));
        }
        if (const auto error = path::validate(autopath.program)) return Unexpected(error->message);
        return autopath;
    }

    void report_next_surfaces(std::vector<std::string>& notes) const {
        for (const solid::WallContour& contour : part_.contours) {
            double nearest = 0;
            const solid::WallEdge* at = nullptr;
            for (const solid::WallEdge& edge : contour.edges) {
                if (edge.next_surface_mm <= 0 || (at != nullptr && edge.next_surface_mm >= nearest)) continue;
                nearest = edge.next_surface_mm;
                at = &edge;
            }
            if (at == nullptr) continue;
            notes.push_back(
                fmt::format("after {} of {} the jet hits the part again, at a distance of {:.4g} mm",
                            at->name, contour.face, nearest));
        }
    }

    // A jet that touches both edges of a wall may cut into a lower edge that is curved more tightly than its
    // width.
    void report_lower_gouges(const std::vector<JetPath>& paths) {
        const EdgeProximity edges(part_.contours, jet_, WallEnd::lower);
        double max_mm = kReportThreshold_mm;
        EdgeProximity::NearestSample max;
        for (const JetPath& jet_path : paths) {
            for (const JetPoint& at : jet_path.points) {
                const auto found = edges.nearest(lower_jet_center(at, jet_), at.axis, at.depth_mm);
                if (rules_.kerf_mm / 2 - found.distance_mm <= max_mm) continue;
                max_mm = rules_.kerf_mm / 2 - found.distance_mm;
                max = found;
            }
        }
        if (max.edge.empty()) return;
        notes_.push_back(
            fmt::format("at lower edges of walls the jet removes up to {:.2g} mm too much: below {} at {}",
                        max_mm, max.edge, display_text(max.position)));
    }

    void report_lower_corners(const std::vector<JetPath>& paths) {
        std::size_t count = 0;
        LowerCorner max;
        std::string edge;
        for (const JetPath& jet_path : paths) {
            for (const LowerCorner& corner : jet_path.lower_corners) {
                if (corner.uncut_mm <= kReportThreshold_mm) continue;
                ++count;
                if (corner.uncut_mm <= max.uncut_mm) continue;
                max = corner;
                edge = jet_path.edges[corner.edge];
            }
        }
        if (count == 0) return;
        notes_.push_back(
            fmt::format("{} corners of lower edges are narrower than the jet: material remains in them, up "
                        "to {:.2g} mm at {}, below {}, where the lower edge turns by {:.0f} deg",
                        count, max.uncut_mm, display_text(max.lower_edge_mm), edge, max.turn_deg));
    }

    const solid::WallContours& part_;
    const cutting::CutRules& rules_;
    const SurfaceOptions& options_;
    JetShape jet_;
    std::vector<std::string> notes_;
};

}  // namespace

Result<cutting::Autopath> surface_path(const solid::WallContours& part, const cutting::CutRules& rules,
                                       const SurfaceOptions& options) {
    return SurfacePathBuilder(part, rules, options).run();
}

}  // namespace gsim::surface

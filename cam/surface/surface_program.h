#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "cam/cutting/autopath.h"
#include "cam/cutting/cut_rules.h"
#include "cam/surface/motion_fit.h"
#include "cam/surface/surface_lead.h"

namespace gsim::surface {

/// A path with its leads, ready to be cut.
struct SurfaceCut {
    JetPath jet_path;
    std::optional<Leads> leads;                     ///< None without enough space.
    std::vector<std::vector<JetPoint>> parts = {};  ///< Parts of the path between bridges.

    Vector pierce(const JetShape& jet) const {
        return leads && leads->in ? leads->in->outer_mm : tcp_position(jet_path.points.front(), jet);
    }
    Vector end(const JetShape& jet) const {
        return leads && leads->out ? leads->out->outer_mm : tcp_position(jet_path.points.back(), jet);
    }
    bool has_both_leads() const { return leads && leads->in && leads->out; }
};

struct SurfaceProgramOptions {
    std::string name;
    JetShape jet;
    FitTolerance tolerance;
    double safe_height_mm = 25;         ///< Over the part, and away from it along the axis.
    double part_top_mm = 0;             ///< The part's highest point, in its own frame.
    Vector origin_mm = Vector::Zero();  ///< Position of the part's origin in the work frame.
    std::optional<Vector> start_mm;     ///< In the work frame: start and end of the program.
    double turn_feed_deg_min = 3600;    ///< For turns at a fixed position.
};

/// Returns the program that makes the cuts in their order, a path for each: over the part at the safe height,
/// down, along the axis to the pierce, jet and abrasive on, pierce time, lead-in, contour, lead-out, off, and
/// back on the same path. Adds the cuts to `summary`.
path::Program surface_program(std::span<const SurfaceCut> cuts, const cutting::CutRules& rules,
                              const SurfaceProgramOptions& options, cutting::CutSummary& summary);

}  // namespace gsim::surface

#pragma once

#include <optional>
#include <string>

#include <tl/expected.hpp>

#include "cam/cutting/autopath.h"
#include "cam/cutting/cut_rules.h"
#include "cam/solid/contours.h"
#include "cam/surface/bridges.h"
#include "cam/surface/jet_way.h"

namespace gsim::surface {

struct SurfaceOptions {
    std::string name;
    JetChoice jet;
    double tolerance_mm = 0.005;  ///< How far the tip may be off its way.
    Bridges bridges;
    double lead_mm = 0;                 ///< Radius of leads; 0: three kerfs.
    double safe_height_mm = 25;         ///< Of ways between cuts, over the part's highest point.
    double cut_height_mm = 3;           ///< Of the tip over the face.
    std::optional<Vector> start_mm;     ///< In the work frame: where the program begins and ends.
    Vector origin_mm = Vector::Zero();  ///< Where the part's origin lies in the work frame.
};

/// From the contours of a part that need not be flat to the path that cuts them: holes first, the nearest
/// next. The error is a sentence that names edge, place and reason.
tl::expected<cutting::Autopath, std::string> surface_path(const solid::WallContours& part,
                                                          const cutting::CutRules& rules,
                                                          const SurfaceOptions& options);

}  // namespace gsim::surface

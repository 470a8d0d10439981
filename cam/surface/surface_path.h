#pragma once

#include <optional>
#include <string>

#include "base/error.h"
#include "cam/cutting/autopath.h"
#include "cam/cutting/cut_rules.h"
#include "cam/solid/contours.h"
#include "cam/surface/bridges.h"
#include "cam/surface/jet_path.h"

namespace gsim::surface {

struct SurfaceOptions {
    std::string name;
    JetOptions jet;
    double tolerance_mm = 0.005;  ///< Max deviation of the TCP from its path.
    Bridges bridges;
    double lead_mm = 0;                 ///< Radius of leads; 0: three kerfs.
    double safe_height_mm = 25;         ///< For moves between cuts, over the part's highest point.
    double cut_height_mm = 3;           ///< Height of the TCP over the face.
    std::optional<Vector> start_mm;     ///< In the work frame: start and end of the program.
    Vector origin_mm = Vector::Zero();  ///< Position of the part's origin in the work frame.
};

/// Returns the path that cuts the contours of a part, which may be curved: holes first, then the nearest
/// next. The error is a message that names edge, position and reason.
Result<cutting::Autopath> surface_path(const solid::WallContours& part, const cutting::CutRules& rules,
                                       const SurfaceOptions& options);

}  // namespace gsim::surface

#pragma once

// Parts that are not flat as users cut them: from the STEP file to what a machine that runs the program
// leaves.

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

#include "tests/apps/run_program.h"
#include "tests/cam/solid/jet_record.h"

namespace gsim::apps {

/// Positions on a part.
using Points = std::vector<Eigen::Vector3d>;

class SurfaceProgram : public Apps {
  protected:
    static constexpr double kKerf_mm = 0.8;
    static constexpr double kNear_mm = 0.05;

    /// Returns the jets of a part on the gantry, in the part's frame, with the part as a body of the cell.
    std::vector<solid::models::Jet> jets(const std::string& step, const Eigen::Vector3d& at,
                                         const std::vector<std::string>& options,
                                         const std::string& cell = {},
                                         const std::string& machine = "af5-measured");

    /// Runs autopath with a part and a kerf.
    Ended autopath(const std::string& step, const std::vector<std::string>& options,
                   const std::string& kerf = "0.8") const;

    /// Expects the edges that the jets cut to be where these points are.
    static void expect_cut(const std::string& what, const Points& points,
                           const std::vector<solid::models::Jet>& jets, double gouge_mm = kNear_mm);

    static std::string sample(const std::string& name);

    std::string told_, report_;
};

/// Points of a curve from 0 to 1, without its end.
Points along(const std::function<Eigen::Vector3d(double)>& curve, int count = 360);

}  // namespace gsim::apps

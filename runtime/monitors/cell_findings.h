#pragma once

#include <Eigen/Core>
#include <array>

#include "runtime/report/report.h"

namespace gsim::simulation {

/// Takes an entry into the list, as long as there is room; false where it is only counted (`dropped`).
bool list(CellFindings& findings, Collision collision);
bool list(CellFindings& findings, BlockClearance clearance);
/// Those of one instant stay in their order.
void sort_by_time(CellFindings& findings);

inline std::array<double, 3> array_of(const Eigen::Vector3d& point) {
    return {point.x(), point.y(), point.z()};
}

}  // namespace gsim::simulation

#pragma once

#include <Eigen/Core>
#include <array>

#include "runtime/report/report.h"

namespace gsim::simulation {

/// Adds an entry to the list, as long as it has space; returns false if the entry is only counted
/// (`dropped`).
bool list(CellFindings& findings, Collision collision);
bool list(CellFindings& findings, BlockClearance clearance);
/// Sorts stably: entries of one instant stay in their order.
void sort_by_time(CellFindings& findings);

inline std::array<double, 3> to_array(const Eigen::Vector3d& point) {
    return {point.x(), point.y(), point.z()};
}

}  // namespace gsim::simulation

#pragma once

#include <memory>
#include <vector>

#include "engine/columns.h"
#include "machine/model/machine.h"
#include "runtime/outputs/run_output.h"

namespace gsim::engine {

/// Returns an output that delivers segments as columns. `machine`, and the TCPs that MoveInfo::tcp indexes,
/// outlive it.
std::unique_ptr<simulation::RunOutput> make_columns_output(
    ColumnsHandler callback, const machine::Machine& machine,
    const std::vector<Eigen::Vector3d>& tcp_offsets_mm);

}  // namespace gsim::engine

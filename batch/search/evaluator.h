#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "base/error.h"
#include "batch/plan/plan.h"

namespace gsim::batch {

/// Batch that has been run.
struct EvaluatedBatch {
    std::int64_t batch = 0;
    bool complete = false;  ///< Else it was cut off.
};

/// Function that runs all jobs of a plan into the results, on any computer; `rerun`: existing runs are
/// repeated.
using Evaluate = std::function<Result<EvaluatedBatch>(const Plan& plan, bool rerun)>;

}  // namespace gsim::batch

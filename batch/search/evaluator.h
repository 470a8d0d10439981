#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include <tl/expected.hpp>

#include "batch/plan/plan.h"

namespace gsim::batch {

/// Batch that has been run.
struct EvaluatedBatch {
    std::int64_t batch = 0;
    bool complete = false;  ///< Else it was cut off.
};

/// Function that runs all jobs of a plan into the results, on any computer; `anew`: existing runs are
/// repeated. The error is a message.
using Evaluate = std::function<tl::expected<EvaluatedBatch, std::string>(const Plan& plan, bool rerun)>;

}  // namespace gsim::batch

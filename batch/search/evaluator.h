#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include <tl/expected.hpp>

#include "batch/plan/plan.h"

namespace gsim::batch {

/// A batch that has been run.
struct Evaluated {
    std::int64_t batch = 0;
    bool whole = false;  ///< Else it was cut off.
};

/// Has all jobs of a plan in the results, wherever they are run; `anew`: what is there already is run all the
/// same. The error is a sentence.
using Evaluate = std::function<tl::expected<Evaluated, std::string>(const Plan& plan, bool anew)>;

}  // namespace gsim::batch

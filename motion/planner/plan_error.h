#pragma once

#include <string>
#include <utility>

#include <tl/expected.hpp>

#include "controller/services/status.h"

namespace gsim::motion {

/// Reason why a target was rejected, or another note about it.
struct PlanError {
    rrs::Status status = rrs::Status::RRS_SUCCESS;
    std::string message;  ///< Message; joints by index from 0, values in mm or rad.
    int joint =
        -1;  ///< The joint that causes the error, if any (RRS_JOINT_LIMIT, or a motor that does not suffice).
    double value = 0;  ///< Value that the joint would take (mm or rad).
    double limit = 0;  ///< That it would pass (mm or rad).
};

using PlanResult = tl::expected<void, PlanError>;

inline tl::unexpected<PlanError> make_plan_error(rrs::Status status, std::string message) {
    return tl::unexpected<PlanError>(PlanError{.status = status, .message = std::move(message)});
}

}  // namespace gsim::motion

#pragma once

#include <string>
#include <utility>

#include <tl/expected.hpp>

#include "controller/services/status.h"

namespace gsim::motion {

/// Why a target was refused, or what else is to be told about it.
struct PlanError {
    rrs::Status status = rrs::Status::RRS_SUCCESS;
    std::string message;  ///< A sentence; joints by index from 0, values in mm or rad.
    int joint = -1;       ///< The joint to blame, where it is one (RRS_JOINT_LIMIT, or a
                          ///< motor that has not enough).
    double value = 0;     ///< That the joint would take (mm or rad).
    double limit = 0;     ///< That it would pass (mm or rad).
};

using Planned = tl::expected<void, PlanError>;

inline tl::unexpected<PlanError> refused(rrs::Status status, std::string message) {
    return tl::unexpected<PlanError>(PlanError{.status = status, .message = std::move(message)});
}

}  // namespace gsim::motion

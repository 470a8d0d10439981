#include "controller/services/status.h"

namespace gsim::rrs {

std::string_view name(Status status) {
    switch (status) {
        case Status::RRS_SUCCESS: return "RRS_SUCCESS";
        case Status::RRS_NEED_MORE_DATA: return "RRS_NEED_MORE_DATA";
        case Status::RRS_TARGET_REACHED: return "RRS_TARGET_REACHED";
        case Status::RRS_MOTION_TIME_RAISED: return "RRS_MOTION_TIME_RAISED";
        case Status::RRS_NOT_INITIALIZED: return "RRS_NOT_INITIALIZED";
        case Status::RRS_SERVICE_NOT_SUPPORTED: return "RRS_SERVICE_NOT_SUPPORTED";
        case Status::RRS_MOTION_TYPE_NOT_SUPPORTED: return "RRS_MOTION_TYPE_NOT_SUPPORTED";
        case Status::RRS_INVALID_PARAMETER: return "RRS_INVALID_PARAMETER";
        case Status::RRS_NO_INITIAL_POSITION: return "RRS_NO_INITIAL_POSITION";
        case Status::RRS_NO_SOLUTION: return "RRS_NO_SOLUTION";
        case Status::RRS_JOINT_LIMIT: return "RRS_JOINT_LIMIT";
        case Status::RRS_CIRCLE_IMPOSSIBLE: return "RRS_CIRCLE_IMPOSSIBLE";
        case Status::RRS_MODE_NOT_SUPPORTED: return "RRS_MODE_NOT_SUPPORTED";
        case Status::RRS_UNKNOWN_FRAME: return "RRS_UNKNOWN_FRAME";
        case Status::RRS_ZERO_SPEED: return "RRS_ZERO_SPEED";
        case Status::RRS_QUEUE_FULL: return "RRS_QUEUE_FULL";
        case Status::RRS_MODULE_FAULT: return "RRS_MODULE_FAULT";
    }
    return "RRS_UNKNOWN_STATUS";
}

}  // namespace gsim::rrs

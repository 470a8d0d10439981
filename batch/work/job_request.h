#pragma once

#include <string>

#include "engine/path_translation.h"
#include "engine/request.h"

namespace gsim::batch {

/// Request to the engine for a job.
struct JobRequest {
    engine::Request run;
    engine::PathRequest path;  ///< If the program is a path, which is written first.
    std::string path_frame;    ///< Frame of the cell that moves the path; empty: none.
    bool joint_speeds = false;
};

}  // namespace gsim::batch

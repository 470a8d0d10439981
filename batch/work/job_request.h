#pragma once

#include <string>

#include "engine/path_translation.h"
#include "engine/request.h"

namespace gsim::batch {

/// What the engine is asked for by a job.
struct JobRequest {
    engine::Request run;
    engine::PathRequest path;  ///< Where the program is a path, which is written first.
    std::string path_frame;    ///< Of the cell, that the path goes along with; empty: with none.
    bool joint_speeds = false;
};

}  // namespace gsim::batch

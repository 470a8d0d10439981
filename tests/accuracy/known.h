#pragma once

#include <map>
#include <string>

namespace gsim::accuracy {

/// Returns the programs with known deviations, as CONTROLLER/PROGRAM without the extension, and the reasons.
inline std::map<std::string, std::string> known_differences() {
    return {};
}

}  // namespace gsim::accuracy

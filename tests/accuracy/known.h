#pragma once

#include <map>
#include <string>

namespace gsim::accuracy {

/// Programs that are known to be off, as CONTROLLER/PROGRAM without the ending, and why.
inline std::map<std::string, std::string> known_differences() {
    return {};
}

}  // namespace gsim::accuracy

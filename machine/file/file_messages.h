#pragma once

#include <string>
#include <vector>

namespace gsim::machine {

/// Messages about a file, each as "file:line:column: message".
struct FileMessages {
    std::vector<std::string> errors;    ///< One for each position; the first one first.
    std::vector<std::string> warnings;  ///< Keys with their names of before.
};

}  // namespace gsim::machine

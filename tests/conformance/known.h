#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"

namespace gsim::conformance {

/// A program that is known not to agree.
struct Known {
    std::string file;    ///< End of its name.
    std::string reason;  ///< Text in the error of gsim-run.
};

/// A list of them: a file's name, white space and what its error holds on each line; `#` begins a remark. The
/// error names the file that cannot be read, or the line without a reason.
Result<std::vector<Known>> read_known(const std::filesystem::path& list);

/// The entry of a program, or nullptr.
const Known* find_known(const std::vector<Known>& known, std::string_view program);

}  // namespace gsim::conformance

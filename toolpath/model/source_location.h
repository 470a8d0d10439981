#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "toolpath/model/path.h"

namespace gsim::path {

/// Position in the file that a program came from; both count from 1, a column of 0 is unknown.
struct SourceLocation {
    std::uint32_t line = 1;
    std::uint32_t column = 0;

    bool operator==(const SourceLocation&) const = default;
};

/// Target of a program, or the path itself.
struct TargetId {
    std::size_t path = 0;               ///< Index in Program::paths.
    std::optional<std::size_t> target;  ///< Index in Path::targets.

    bool operator==(const TargetId&) const = default;
};

/// Program with the file that it came from.
struct PathFile {
    Program program;
    std::string file_name;
    std::vector<SourceLocation> paths;                 ///< One for each path.
    std::vector<std::vector<SourceLocation>> targets;  ///< One for each target of each path.

    /// Returns "file:line:column: message".
    std::string with_location(const TargetId& id, const std::string& message) const;
};

}  // namespace gsim::path

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "runtime/simulator/move.h"

namespace gsim::simulation {

/// Names of the files that source locations of a run refer to.
class SourceFiles {
  public:
    /// Returns the index for SourceLocation::file of a file name; adds a new name.
    std::uint32_t add(const std::string& name);
    /// Returns the names by their index.
    const std::vector<std::string>& names() const { return names_; }
    /// Returns "FILE:LINE: ", which begins a message; empty if the location is unknown.
    std::string prefix(const SourceLocation& location) const;

  private:
    std::vector<std::string> names_;
};

}  // namespace gsim::simulation

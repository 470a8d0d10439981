#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "tests/conformance/canon_reader.h"
#include "tests/conformance/scratch_folder.h"
#include "tests/conformance/tool_rows.h"

namespace gsim::conformance {

/// LinuxCNC's stand-alone interpreter, if it is installed.
class ReferenceInterpreter {
  public:
    /// `command`: the program, `rs274` say, found by PATH.
    ReferenceInterpreter(std::string command, const std::vector<ToolRow>& tools);

    /// Returns true if it exists and runs an empty program to its end.
    bool is_installed() const;
    /// Returns its moves for a program that is run alone, or none if it rejects the program. The error is a
    /// message about output that cannot be parsed.
    Result<std::optional<std::vector<ExpectedMove>>> moves(const std::filesystem::path& program) const;

  private:
    std::optional<std::string> canonical_output(const std::filesystem::path& program) const;

    std::string command_;
    ScratchFolder scratch_;
    std::filesystem::path tools_;
};

}  // namespace gsim::conformance

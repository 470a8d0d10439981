#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "tests/conformance/canon_reader.h"
#include "tests/conformance/scratch_folder.h"
#include "tests/conformance/tool_rows.h"

namespace gsim::conformance {

/// LinuxCNC's stand-alone interpreter, where it is installed.
class ReferenceInterpreter {
  public:
    /// `command`: the program, `rs274` say, found by PATH.
    ReferenceInterpreter(std::string command, const std::vector<ToolRow>& tools);

    /// Whether it is there and runs an empty program to its end.
    bool is_installed() const;
    /// What it makes of a program that is run alone; nothing where it refuses it. The error is a sentence
    /// about output that cannot be understood.
    tl::expected<std::optional<std::vector<ExpectedMove>>, std::string> moves(
        const std::filesystem::path& program) const;

  private:
    std::optional<std::string> canonical_output(const std::filesystem::path& program) const;

    std::string command_;
    ScratchFolder scratch_;
    std::filesystem::path tools_;
};

}  // namespace gsim::conformance

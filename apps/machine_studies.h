#pragma once

#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "cli/command_line.h"
#include "engine/machine.h"

namespace gsim::apps {

/// What gsim-run tells of a machine without a program.
struct MachineStudies {
    std::string check;                   ///< A machine file to check; empty: not wanted.
    std::vector<std::string> envelopes;  ///< Files for the working envelope.
    std::string axes;                    ///< A file for the picture of what each axis does.

    bool any() const { return !check.empty() || !envelopes.empty() || !axes.empty(); }
};

void add_study_options(CommandLine& line, MachineStudies& studies);

/// How to tell what was found.
struct StudyOutput {
    bool json = false;
    bool quiet = false;  ///< Nothing for people on standard output.
};

/// Makes what was asked for: prints the check, and writes the envelopes. The exit status; the error is a
/// sentence on files.
tl::expected<int, std::string> run_studies(const MachineStudies& studies, engine::Machine& machine,
                                           const StudyOutput& output);

}  // namespace gsim::apps

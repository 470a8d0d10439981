#pragma once

#include <string>
#include <vector>

#include "base/error.h"
#include "cli/command_line.h"
#include "engine/machine.h"

namespace gsim::apps {

/// Reports of gsim-run on a machine without a program.
struct MachineStudies {
    std::string check;                   ///< Machine file to check; empty: not wanted.
    std::vector<std::string> envelopes;  ///< Files for the working envelope.
    std::string axes;                    ///< A file for the picture of what each axis does.

    bool any() const { return !check.empty() || !envelopes.empty() || !axes.empty(); }
};

void add_study_options(CommandLine& line, MachineStudies& studies);

/// Output settings of the studies.
struct StudyOutput {
    bool json = false;
    bool quiet = false;  ///< No report for people on standard output.
};

/// Runs the requested studies: prints the check and writes the envelopes. Returns the exit status; the error
/// is a message about files.
Result<int> run_studies(const MachineStudies& studies, engine::Machine& machine, const StudyOutput& output);

}  // namespace gsim::apps

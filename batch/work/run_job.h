#pragma once

#include <map>
#include <optional>
#include <string>

#include <tl/expected.hpp>

#include "batch/work/input_files.h"
#include "batch/work/job.h"
#include "batch/work/job_request.h"
#include "batch/work/run_files.h"
#include "batch/work/run_row.h"
#include "engine/run.h"

namespace gsim::batch {

/// Inputs of a job that no file contains. Names are those of files; empty: none, or the machine is that of
/// the cell or the built-in one.
struct JobTexts {
    std::string machine = {}, machine_data = {}, cell = {}, robots = {};
    std::map<std::string, std::string> changed = {};  ///< Texts that replace those of these files.
    std::optional<std::string> program = {};          ///< Written of a path.
};

/// Runner of jobs, one at a time in this process. Objects that all jobs need are created once.
class JobRunner {
  public:
    JobRunner();

    /// Runs a job and returns its row. Errors of the job are part of the row.
    RunRow run(const Job& job);
    /// Returns the texts that it would run.
    tl::expected<JobTexts, engine::Error> job_texts(const Job& job);

  private:
    RunRow run_unguarded(const Job& job);
    tl::expected<JobRequest, engine::Error> prepare(const Job& job, RunFiles& files) const;

    InputFiles files_;
    engine::CompiledLuaLibrary library_;
    engine::Host system_;
};

}  // namespace gsim::batch

#pragma once

#include <map>
#include <optional>
#include <string>

#include <tl/expected.hpp>

#include "batch/work/files_of_run.h"
#include "batch/work/input_files.h"
#include "batch/work/job.h"
#include "batch/work/job_request.h"
#include "batch/work/run_row.h"
#include "engine/run.h"

namespace gsim::batch {

/// What a job has the engine read that no file has. Names are those of files; empty: there is none, or the
/// machine is that of the cell or the one built in.
struct JobTexts {
    std::string machine = {}, machine_data = {}, cell = {}, robots = {};
    std::map<std::string, std::string> changed = {};  ///< Texts in place of those of these files.
    std::optional<std::string> program = {};          ///< Written of a path.
};

/// Runs jobs one after the other in this process. What all need is made once.
class JobRunner {
  public:
    JobRunner();

    /// What came of it; nothing that goes wrong with a job is an error here.
    RunRow run(const Job& job);
    /// What it would run.
    tl::expected<JobTexts, engine::Failure> texts_of(const Job& job);

  private:
    RunRow run_unguarded(const Job& job);
    tl::expected<JobRequest, engine::Failure> prepare(const Job& job, FilesOfRun& files) const;

    InputFiles files_;
    engine::SharedLibrary library_;
    engine::Host system_;
};

}  // namespace gsim::batch

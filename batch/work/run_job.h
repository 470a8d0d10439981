#pragma once

#include <set>
#include <string>

#include "batch/work/input_files.h"
#include "batch/work/job.h"
#include "batch/work/run_row.h"
#include "engine/run.h"

namespace gsim::batch {

/// Runs jobs one after the other in this process. What all need is made once.
class JobRunner {
  public:
    JobRunner();

    /// What came of it; nothing that goes wrong with a job is an error here.
    RunRow run(const Job& job);

  private:
    RunRow run_unguarded(const Job& job);

    InputFiles files_;
    engine::SharedLibrary library_;
    engine::Host system_;
};

}  // namespace gsim::batch

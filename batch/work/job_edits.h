#pragma once

#include <string>

#include "base/error.h"
#include "batch/work/job.h"
#include "batch/work/job_request.h"
#include "batch/work/run_files.h"

namespace gsim::batch {

/// Applies a job's options and its settings of the run.
Result<void> set_options(const Job& job, JobRequest& request);

/// Replaces the files of the job's settings by edited texts: cell, robots, machine, data. Names in the
/// request become names of files.
Result<void> make_edits(const Job& job, engine::Request& request, RunFiles& files);

}  // namespace gsim::batch

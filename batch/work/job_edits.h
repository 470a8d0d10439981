#pragma once

#include <string>

#include <tl/expected.hpp>

#include "batch/work/files_of_run.h"
#include "batch/work/job.h"
#include "batch/work/job_request.h"

namespace gsim::batch {

/// What a job's options and its settings of the run say. The error is a sentence.
tl::expected<void, std::string> set_options(const Job& job, JobRequest& request);

/// Puts edited texts in place of the files that the job's settings are of: cell, robots, machine, data. Names
/// of the request become those of files. The error is a sentence.
tl::expected<void, std::string> make_edits(const Job& job, engine::Request& request, FilesOfRun& files);

}  // namespace gsim::batch

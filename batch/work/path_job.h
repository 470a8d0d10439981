#pragma once

#include <optional>
#include <span>
#include <string>

#include <tl/expected.hpp>

#include "base/error.h"
#include "batch/work/job.h"
#include "batch/work/job_request.h"
#include "engine/diagnostic.h"

namespace gsim::batch {

/// Returns true if a program is a path (docs/paths.md): its name ends in .path.json or .path.lua. A program
/// is first written from it for its machine, and then run.
bool is_path_file(const std::string& name);

/// Returns an error if a setting's key, without its "path.", is invalid.
std::optional<Error> find_path_key_error(const std::string& key);

/// Returns the changes of a path by settings, with keys without "path.": `place.x_mm` and the like, `order`,
/// `feed_mm_min`, `NAME.feed_mm_min`.
Result<engine::PathChanges> path_changes(std::span<const SettingValue> settings);

/// Returns the text of a job's program if that is a path, written for the machine of the request; empty for
/// other jobs. `original_host` has files without the job's edits: they define the pose of the cell's frame
/// that moves the path.
tl::expected<std::optional<std::string>, engine::Error> write_path(const Job& job, const JobRequest& request,
                                                                   const engine::Host& original_host);

}  // namespace gsim::batch

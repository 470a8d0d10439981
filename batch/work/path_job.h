#pragma once

#include <optional>
#include <span>
#include <string>

#include <tl/expected.hpp>

#include "batch/work/job.h"
#include "batch/work/job_request.h"
#include "engine/diagnostic.h"

namespace gsim::batch {

/// Whether a program is a path (docs/paths.md): its name ends in .path.json or .path.lua. It is written for
/// its machine first, and what is run is that.
bool is_path(const std::string& name);

/// Why a key of a setting, without its "path.", is none; nothing where it is one.
std::string fault_of_path_key(const std::string& key);

/// What settings, their keys without "path.", make of a path: `place.x_mm` and the like, `order`,
/// `feed_mm_min`, `NAME.feed_mm_min`. The error is a sentence.
tl::expected<engine::PathChanges, std::string> path_changes(std::span<const SettingValue> settings);

/// The text of the program of a job whose program is a path, written for the machine of the request; nothing
/// of other jobs. `as_it_is` has files without the job's edits: there the cell's frame stands that the path
/// goes along with.
tl::expected<std::optional<std::string>, engine::Failure> write_path(const Job& job,
                                                                     const JobRequest& request,
                                                                     const engine::Host& as_it_is);

}  // namespace gsim::batch

#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "apps/outputs.h"
#include "apps/run_arguments.h"
#include "base/error.h"
#include "base/os/file_lock.h"
#include "engine/run.h"

namespace gsim::apps {

/// Returns an error if an output is a file with another use, or one that two robots would both write.
std::optional<Error> output_conflict(const RunArguments& arguments, const engine::Run& run);

/// Returns the message of the first incomplete document that has an error with this code.
Result<void> document_error(const engine::Run& run, const std::string& code);

/// Files that a run writes, for all its robots.
class RunOutputs {
  public:
    /// Same as Outputs::open().
    static Result<RunOutputs> open(const RunArguments& arguments, engine::Run& run);
    /// Same as Outputs::commit().
    Result<void> commit(const engine::Report& report);

  private:
    std::vector<std::unique_ptr<Outputs>> outputs_;  ///< With several robots, that of the report comes last.
};

/// Files in which a controller keeps data from one run to the next.
class PersistentFiles {
  public:
    /// Locks the files, so that no other program changes them from before they are read until they are
    /// written.
    Result<void> lock(const RunArguments& arguments, const engine::Run& run);
    /// Checks that they can be written after the run.
    static Result<void> check(const RunArguments& arguments);
    /// Writes them as the run left them.
    Result<void> write(const RunArguments& arguments, const engine::Run& run) const;

  private:
    std::vector<os::FileLock> locks_;
    bool is_in_place_ = false;  ///< Machine data are written back to their source file.
};

}  // namespace gsim::apps

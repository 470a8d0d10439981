#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "apps/outputs.h"
#include "apps/run_arguments.h"
#include "base/os/file_lock.h"
#include "engine/run.h"

namespace gsim::apps {

/// An output that is a file which another file has named, or that two robots would both write, as a sentence.
std::optional<std::string> conflict_of_outputs(const RunArguments& arguments, const engine::Run& run);

/// The first document that lacks something, of those whose fault has this code, as a sentence.
tl::expected<void, std::string> fault_of_documents(const engine::Run& run, const std::string& code);

/// The files that a run writes, of all its robots.
class RunOutputs {
  public:
    /// As Outputs::open().
    static tl::expected<RunOutputs, std::string> open(const RunArguments& arguments, engine::Run& run);
    /// As Outputs::commit().
    tl::expected<void, std::string> commit(const engine::Report& report);

  private:
    std::vector<std::unique_ptr<Outputs>> outputs_;  ///< Of several robots that of the report comes last.
};

/// What a control keeps from one run to the next, in files.
class KeptFiles {
  public:
    /// Nobody else changes them from before they are read until they are written. The error is a sentence.
    tl::expected<void, std::string> lock(const RunArguments& arguments, const engine::Run& run);
    /// Whether they can be written behind the run.
    static tl::expected<void, std::string> check(const RunArguments& arguments);
    /// As the run left them.
    tl::expected<void, std::string> write(const RunArguments& arguments, const engine::Run& run) const;

  private:
    std::vector<os::FileLock> locks_;
    bool in_place_ = false;  ///< Machine data are written back to where they were read.
};

}  // namespace gsim::apps

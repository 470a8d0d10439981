#pragma once

#include <optional>
#include <string>
#include <unordered_map>

#include "base/error.h"
#include "batch/store/results.h"
#include "batch/work/input_files.h"
#include "batch/work/job.h"
#include "engine/host.h"

namespace gsim::batch {

/// Run cache: finds earlier runs by all inputs that determine them.
class RunCache {
  public:
    RunCache();

    /// Returns the program's version, with a mark that distinguishes builds.
    const std::string& version() const { return version_; }
    /// Returns the key of a job, as known before a run: this program, the job, and the files that it names.
    /// Other files that the run reads are checked when the run is found again.
    RunKey run_key(const Job& job);
    /// Same as Results::find().
    Result<std::optional<Results::StoredRun>> find(Results& results, const RunKey& key, const Job& job,
                                                   bool retry);

  private:
    std::string machine_hash(const std::string& name);

    engine::Host host_;
    InputFiles files_;
    std::unordered_map<std::string, std::string> machines_;  ///< Files, by names of machines.
    std::string version_;
};

}  // namespace gsim::batch

#pragma once

#include <optional>
#include <string>
#include <unordered_map>

#include <tl/expected.hpp>

#include "batch/store/results.h"
#include "batch/work/input_files.h"
#include "batch/work/job.h"
#include "engine/host.h"

namespace gsim::batch {

/// Finds runs that were made before, by all that makes them what they are.
class KnownRuns {
  public:
    KnownRuns();

    /// The program's version, with what tells one build from another.
    const std::string& version() const { return version_; }
    /// All that is known before a run: this program, the job, and the files that it names. What it reads
    /// beside those is looked at where it is found again.
    RunKey key_of(const Job& job);
    /// As Results::find().
    tl::expected<std::optional<Results::FoundRun>, std::string> find(Results& results, const RunKey& key,
                                                                     const Job& job, bool retry);

  private:
    std::string hash_of_machine(const std::string& name);

    engine::Host host_;
    InputFiles files_;
    std::unordered_map<std::string, std::string> machines_;  ///< Files, by names of machines.
    std::string version_;
};

}  // namespace gsim::batch

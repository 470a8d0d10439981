#pragma once

#include <cstdint>
#include <list>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/os/descriptor.h"

namespace gsim::studio {

/// Complete segment messages of a run that is too long for a page, in order in an unnamed file. They may be
/// read while the engine still adds some.
class StoredRun {
  public:
    /// Creates the file.
    static Result<std::shared_ptr<StoredRun>> make();
    explicit StoredRun(os::Descriptor file) : file_(std::move(file)) {}

    /// Returns the descriptor for the writer.
    int number() const { return file_.number(); }
    /// Returns the message of that number, from 0; no value if it does not exist.
    std::optional<std::string> message(std::size_t index);

  private:
    std::mutex mutex_;
    os::Descriptor file_;
    std::vector<std::uint64_t> message_offsets_{0};  // of messages that are known, and of the next one
};

/// Kept runs of a server, by the names that pages give them: the last few.
class StoredRuns {
  public:
    /// Adds a new run; the oldest is removed if many exist.
    Result<std::shared_ptr<StoredRun>> add(const std::string& name);
    /// Returns null if the run has been removed.
    std::shared_ptr<StoredRun> find(const std::string& name);
    /// Removes the run, whatever its name is.
    void drop(const std::shared_ptr<StoredRun>& run);

  private:
    struct NamedRun {
        std::string name;
        std::shared_ptr<StoredRun> run;
    };
    std::mutex mutex_;
    std::list<NamedRun> runs_;
};

}  // namespace gsim::studio

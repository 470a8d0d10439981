#pragma once

#include <cstdint>
#include <list>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "base/os/descriptor.h"

namespace gsim::studio {

/// The whole messages of segments of a run that is too long for a page, one behind the other in a file
/// without a name. They may be read while the engine still adds some.
class KeptRun {
  public:
    /// The error is a sentence.
    static tl::expected<std::shared_ptr<KeptRun>, std::string> make();
    explicit KeptRun(os::Descriptor file) : file_(std::move(file)) {}

    /// For who writes it.
    int number() const { return file_.number(); }
    /// The message of that number, from 0; nothing where it is not there.
    std::optional<std::string> message(std::size_t index);

  private:
    std::mutex mutex_;
    os::Descriptor file_;
    std::vector<std::uint64_t> starts_{0};  // of messages that are known, and of the next one
};

/// Those of a server, by the names that pages give them: the last few.
class KeptRuns {
  public:
    /// A new one; the oldest goes where there are many.
    tl::expected<std::shared_ptr<KeptRun>, std::string> add(const std::string& name);
    /// Null: it has gone.
    std::shared_ptr<KeptRun> find(const std::string& name);
    /// It is kept no more, whatever it is called.
    void drop(const std::shared_ptr<KeptRun>& run);

  private:
    struct Named {
        std::string name;
        std::shared_ptr<KeptRun> run;
    };
    std::mutex mutex_;
    std::list<Named> runs_;
};

}  // namespace gsim::studio

#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <sys/types.h>
#include <tl/expected.hpp>

#include "base/os/descriptor.h"

namespace gsim::studio {

/// The engine at work on one thing that a page asks for, in a process of its own: it may be ended at any
/// instant, and what it does not survive the server does. Goes with this object, at once.
class EngineProcess {
  public:
    /// `command` reads what is asked from its standard input, and writes messages (docs/studio.md) to its
    /// standard output. `kept`: a file that it has as descriptor 3; -1: none. The error is a sentence.
    static tl::expected<EngineProcess, std::string> begin(const std::vector<std::string>& command,
                                                          std::string_view asked, int kept = -1);
    static constexpr int kKeptDescriptor = 3;
    EngineProcess(EngineProcess&& other) noexcept;
    EngineProcess& operator=(EngineProcess&&) = delete;
    ~EngineProcess();

    /// Waits for what it writes: a piece of it; nothing is there where it is empty, and the end where it is
    /// nothing.
    std::optional<std::string> read(int longest_wait_ms);
    /// Behind the end: why it did not do all, as a sentence; empty: it did.
    std::string fault();

  private:
    EngineProcess(pid_t child, os::Descriptor output) : child_(child), output_(std::move(output)) {}

    pid_t child_;  // -1: none
    os::Descriptor output_;
};

}  // namespace gsim::studio

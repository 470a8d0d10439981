#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <sys/types.h>

#include "base/error.h"
#include "base/os/descriptor.h"

namespace gsim::studio {

/// Process of the engine for one request of a page. It may be ended at any instant, and the server survives
/// its crash. It ends with this object, at once.
class EngineProcess {
  public:
    /// Starts `command`, which reads the request from its standard input, and writes messages
    /// (docs/studio.md) to its standard output. `kept`: a file that it gets as descriptor 3; -1: none.
    static Result<EngineProcess> begin(const std::vector<std::string>& command, std::string_view request_text,
                                       int kept = -1);
    static constexpr int kFileDescriptor = 3;
    EngineProcess(EngineProcess&& other) noexcept;
    EngineProcess& operator=(EngineProcess&&) = delete;
    ~EngineProcess();

    /// Waits for output and returns a part of it; an empty text: no output yet, no value: the end.
    std::optional<std::string> read(int timeout_ms);
    /// Returns after the end a message why the process failed; empty: it succeeded.
    std::string error();

  private:
    EngineProcess(pid_t child, os::Descriptor output) : child_(child), output_(std::move(output)) {}

    pid_t child_;  // -1: none
    os::Descriptor output_;
};

}  // namespace gsim::studio

#pragma once

#include <string>
#include <vector>

namespace gsim::bench {

/// What one run of a command took.
struct Usage {
    /// User and system time together.
    double cpu_s = 0.0;
    /// Peak resident memory, in units of 1,000,000 bytes.
    double peak_mb = 0.0;
    /// Exit status; 128 and the signal's number if a signal ended it, as shells have it.
    int status = 0;
};

/// Runs a command (looked up on PATH) to its end with nothing on its standard input, its output thrown away.
/// A command that cannot be started has status 127; what it says on standard error is seen. Throws
/// std::system_error when the machine has no process to give.
Usage measure(const std::vector<std::string>& command);

}  // namespace gsim::bench

#pragma once

#include <string>
#include <vector>

namespace gsim::bench {

/// Resources that one run of a command used.
struct Usage {
    /// Sum of user and system time.
    double cpu_s = 0.0;
    /// Peak resident memory, in units of 1,000,000 bytes.
    double peak_mb = 0.0;
    /// Exit status, or 128 plus the signal's number if a signal ended it, as in shells.
    int status = 0;
};

/// Runs a command (looked up on PATH) to its end with an empty standard input; its output is discarded. A
/// command that cannot be started has status 127; its messages on standard error remain visible. Throws
/// std::system_error if the machine cannot create a process.
Usage measure(const std::vector<std::string>& command);

}  // namespace gsim::bench

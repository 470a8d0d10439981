#pragma once

#include <atomic>

namespace gsim::batch {

/// Returns the flag that is set if the user or the system requests the end: work in progress is completed.
std::atomic<bool>& stop_flag();
/// Sets the flag on SIGINT and SIGTERM from now on; a second one ends the program at once.
void stop_on_signals();
/// Sets it on SIGTERM alone, as for tasks of a cluster.
void stop_on_sigterm();

}  // namespace gsim::batch

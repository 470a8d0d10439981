#pragma once

#include <atomic>

namespace gsim::batch {

/// Set where the user, or whoever runs this, asks it to end: what is under way comes to its end.
std::atomic<bool>& stop_flag();
/// SIGINT and SIGTERM set it from now on; a second one ends the program at once.
void stop_on_signals();
/// SIGTERM alone, as tasks of a cluster have it.
void stop_when_ended();

}  // namespace gsim::batch

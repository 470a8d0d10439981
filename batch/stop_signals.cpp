#include "batch/stop_signals.h"

#include <csignal>

namespace gsim::batch {

namespace {

extern "C" void request_stop(int signal) {
    if (stop_flag().exchange(true)) {
        // A second signal means that the user does not want to wait.
        std::signal(signal, SIG_DFL);
        std::raise(signal);
    }
}

}  // namespace

std::atomic<bool>& stop_flag() {
    static std::atomic<bool> stop = false;  // a signal handler can access only globals
    return stop;
}

void stop_on_signals() {
    std::signal(SIGINT, request_stop);
    std::signal(SIGTERM, request_stop);
}

void stop_on_sigterm() {
    std::signal(SIGTERM, request_stop);
}

}  // namespace gsim::batch

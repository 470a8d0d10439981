#include "base/os/temporary_name.h"

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstring>

#include <unistd.h>

namespace gsim::os {

namespace {

constexpr std::array kTerminationSignals = {SIGHUP, SIGINT, SIGQUIT, SIGPIPE, SIGTERM, SIGXCPU};
constexpr int kWriteFailedStatus = 2;              // same status as for unwritable output
constexpr std::size_t kMaxRegisteredNames = 4096;  // more than a process may have files open, as a rule

// The only global state of the program: a signal handler gets only a number, and may access only lock-free
// atomics. A name beyond kMaxRegisteredNames is not removed at a signal.
std::array<std::atomic<const char*>, kMaxRegisteredNames> registered_names{};
std::atomic<pid_t> registering_process = 0;
std::atomic<const char*> message_at_cpu_signal = nullptr;
std::atomic<int> status_at_cpu_signal = 0;
static_assert(std::atomic<const char*>::is_always_lock_free && std::atomic<pid_t>::is_always_lock_free);

extern "C" void remove_and_terminate(int signal) {
    const int error = errno;
    gsim::os::remove_temporaries();
    const char* const words = signal == SIGXCPU ? message_at_cpu_signal.load() : nullptr;
    if (words != nullptr) {
        const bool is_written = ::write(STDERR_FILENO, words, std::strlen(words)) > 0;
        ::_exit(is_written ? status_at_cpu_signal.load() : kWriteFailedStatus);
    }
    std::signal(signal, SIG_DFL);
    static_cast<void>(::raise(signal));  // comes when the handler returns
    errno = error;
}

extern "C" void do_nothing(int) {}

void handle(int signal, void (*handler)(int)) {
    struct sigaction action {};
    if (::sigaction(signal, nullptr, &action) != 0 || action.sa_handler != SIG_DFL) return;
    action.sa_handler = handler;
    action.sa_flags = SA_RESTART;
    sigemptyset(&action.sa_mask);
    for (const int other : kTerminationSignals) sigaddset(&action.sa_mask, other);
    ::sigaction(signal, &action, nullptr);
}

}  // namespace

void remove_temporaries() {
    // A forked child has the same list, of files that belong to its parent.
    if (registering_process.load() != ::getpid()) return;
    for (const auto& slot : registered_names) {
        if (const char* name = slot.load()) ::unlink(name);
    }
}

void remove_temporaries_at_signals() {
    registering_process = ::getpid();
    for (const int signal : kTerminationSignals) handle(signal, remove_and_terminate);
    handle(SIGXFSZ, do_nothing);  // not SIG_IGN, which the programs that we run would inherit
}

void exit_at_cpu_signal(const char* exit_message, int status) {
    status_at_cpu_signal = status;
    message_at_cpu_signal = exit_message;
    if (exit_message == nullptr) return;
    std::signal(SIGXCPU, SIG_DFL);  // also if it was ignored
    handle(SIGXCPU, remove_and_terminate);
}

SignalBlocker::SignalBlocker() : old_signal_mask_() {
    sigset_t blocked_signals;
    sigemptyset(&blocked_signals);
    for (const int signal : kTerminationSignals) sigaddset(&blocked_signals, signal);
    ::pthread_sigmask(SIG_BLOCK, &blocked_signals, &old_signal_mask_);
}

SignalBlocker::~SignalBlocker() {
    ::pthread_sigmask(SIG_SETMASK, &old_signal_mask_, nullptr);
}

TemporaryName::TemporaryPath TemporaryName::temporary_path(const std::filesystem::path& file) {
    return std::make_unique<const std::string>(file.string());
}

TemporaryName::TemporaryName(TemporaryPath name) noexcept : name_(std::move(name)) {
    for (auto& slot : registered_names) {
        const char* none = nullptr;
        if (slot.compare_exchange_strong(none, name_->c_str())) return;
    }
}

TemporaryName::~TemporaryName() {
    if (empty()) return;
    const SignalBlocker blocked_signals;  // what has this name afterwards may be another program's
    ::unlink(name_->c_str());
    release();
}

void TemporaryName::release() {
    for (auto& slot : registered_names) {
        const char* name = name_->c_str();
        if (slot.compare_exchange_strong(name, nullptr)) break;
    }
    name_.reset();
}

}  // namespace gsim::os

#include "controller/module/rcs_trial.h"

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <optional>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/os/descriptor.h"

namespace gsim::rrs {

namespace {

using Clock = std::chrono::steady_clock;

constexpr char kEndOfMessage = '\0';  // ends what the work says: a child that ends before has not done it

std::string system_error(const char* what) {
    return fmt::format("could not be tested ({}: {})", what, std::generic_category().message(errno));
}

/// Crashes must reach the parent as signals: no core files, no foreign handlers.
void reset_process_state() {
    const rlimit none{};
    ::setrlimit(RLIMIT_CORE, &none);
    for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGTERM}) {
        std::signal(signal, SIG_DFL);
    }
    std::signal(SIGPIPE, SIG_IGN);
}

[[noreturn]] void run_child(const std::function<std::string()>& work, int output) {
    reset_process_state();
    std::string reply;
    try {
        reply = work();
    } catch (...) {
        ::_exit(1);
    }
    reply += kEndOfMessage;
    std::size_t written = 0;
    while (written < reply.size()) {
        const ssize_t size = ::write(output, reply.data() + written, reply.size() - written);
        if (size <= 0) break;
        written += static_cast<std::size_t>(size);
    }
    ::_exit(0);
}

/// Returns the input until the end of the pipe or kEndOfMessage; nothing if that takes too long.
std::optional<std::string> read_output(int input, int timeout_ms) {
    const auto end = Clock::now() + std::chrono::milliseconds(timeout_ms);
    std::string reply;
    while (reply.empty() || reply.back() != kEndOfMessage) {
        const auto remaining =
            std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now()).count();
        if (remaining <= 0) return std::nullopt;
        pollfd waiting{.fd = input, .events = POLLIN, .revents = 0};
        if (::poll(&waiting, 1, static_cast<int>(remaining)) <= 0) continue;
        std::array<char, 4096> bytes;
        const ssize_t size = ::read(input, bytes.data(), bytes.size());
        if (size == 0) break;
        if (size > 0) reply.append(bytes.data(), static_cast<std::size_t>(size));
    }
    return reply;
}

int wait_for(pid_t child) {
    int status = 0;
    while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    return status;
}

}  // namespace

Result<std::string> run_trial(const std::function<std::string()>& work, int timeout_ms) {
    int ends[2];
    if (::pipe2(ends, O_CLOEXEC) != 0) return tl::unexpected(system_error("pipe"));
    const os::Descriptor input(ends[0]);
    os::Descriptor output(ends[1]);
    std::fflush(nullptr);  // a child that calls exit() would write what is in the buffers once more
    const pid_t child = ::fork();
    if (child < 0) return tl::unexpected(system_error("fork"));
    if (child == 0) run_child(work, output.number());
    output.close();
    std::optional<std::string> reply = read_output(input.number(), timeout_ms);
    if (!reply) ::kill(child, SIGKILL);
    const int status = wait_for(child);
    if (!reply) return Unexpected(fmt::format("did not respond within {} s", timeout_ms / 1000.0));
    if (WIFSIGNALED(status)) return Unexpected(fmt::format("crashed (signal {})", WTERMSIG(status)));
    if (reply->empty() || reply->back() != kEndOfMessage) return Unexpected("ended the program");
    reply->pop_back();
    return *reply;
}

}  // namespace gsim::rrs

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

constexpr char kDone = '\0';  // ends what the work says: a child that ends before has not done it

std::string system_error(const char* what) {
    return fmt::format("could not be tried ({}: {})", what, std::generic_category().message(errno));
}

/// Crashes must reach the parent as signals: no core files, no foreign handlers.
void be_plain() {
    const rlimit none{};
    ::setrlimit(RLIMIT_CORE, &none);
    for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGTERM}) {
        std::signal(signal, SIG_DFL);
    }
    std::signal(SIGPIPE, SIG_IGN);
}

[[noreturn]] void be_child(const std::function<std::string()>& work, int output) {
    be_plain();
    std::string said;
    try {
        said = work();
    } catch (...) {
        ::_exit(1);
    }
    said += kDone;
    std::size_t written = 0;
    while (written < said.size()) {
        const ssize_t size = ::write(output, said.data() + written, said.size() - written);
        if (size <= 0) break;
        written += static_cast<std::size_t>(size);
    }
    ::_exit(0);
}

/// Returns the input until the end of the pipe or kDone; nothing if that takes too long.
std::optional<std::string> read_answer(int input, int timeout_ms) {
    const auto end = Clock::now() + std::chrono::milliseconds(timeout_ms);
    std::string said;
    while (said.empty() || said.back() != kDone) {
        const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now()).count();
        if (left <= 0) return std::nullopt;
        pollfd waiting{.fd = input, .events = POLLIN, .revents = 0};
        if (::poll(&waiting, 1, static_cast<int>(left)) <= 0) continue;
        std::array<char, 4096> bytes;
        const ssize_t size = ::read(input, bytes.data(), bytes.size());
        if (size == 0) break;
        if (size > 0) said.append(bytes.data(), static_cast<std::size_t>(size));
    }
    return said;
}

int wait_for(pid_t child) {
    int status = 0;
    while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    return status;
}

}  // namespace

tl::expected<std::string, std::string> run_trial(const std::function<std::string()>& work, int timeout_ms) {
    int ends[2];
    if (::pipe2(ends, O_CLOEXEC) != 0) return tl::unexpected(system_error("pipe"));
    const os::Descriptor input(ends[0]);
    os::Descriptor output(ends[1]);
    std::fflush(nullptr);  // a child that calls exit() would write what is in the buffers once more
    const pid_t child = ::fork();
    if (child < 0) return tl::unexpected(system_error("fork"));
    if (child == 0) be_child(work, output.number());
    output.close();
    std::optional<std::string> said = read_answer(input.number(), timeout_ms);
    if (!said) ::kill(child, SIGKILL);
    const int status = wait_for(child);
    if (!said) return tl::unexpected(fmt::format("gave no answer within {} s", timeout_ms / 1000.0));
    if (WIFSIGNALED(status)) return tl::unexpected(fmt::format("crashed (signal {})", WTERMSIG(status)));
    if (said->empty() || said->back() != kDone) return tl::unexpected<std::string>("ended the program");
    said->pop_back();
    return *said;
}

}  // namespace gsim::rrs

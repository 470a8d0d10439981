// gsim-rcs-host: the process in which a controller module runs. gsim starts it and communicates with it as
// defined in rcs_shared.h.

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#include "controller/module/rcs_host.h"
#include "controller/module/rcs_link.h"
#include "controller/module/rcs_shared.h"
#include "controller/module/rcs_values.h"

#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define GSIM_TAKES_ADDRESSES
#endif
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define GSIM_TAKES_ADDRESSES
#endif

namespace gsim::rrs {

namespace {

using Clock = std::chrono::steady_clock;

constexpr int kUsage = 2;
constexpr auto kLongestAhead = std::chrono::milliseconds(100);  // of steps between two responses

/// Crashes are visible from outside as signals and use no disk space; memory use is limited.
void bound_process(std::uint64_t memory_bytes) {
    const rlimit none{};
    ::setrlimit(RLIMIT_CORE, &none);
    for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGTERM}) std::signal(signal, SIG_DFL);
#ifndef GSIM_TAKES_ADDRESSES
    rlimit memory{};
    if (memory_bytes == 0 || ::getrlimit(RLIMIT_AS, &memory) != 0) return;
    memory.rlim_cur = std::min<rlim_t>(memory_bytes, memory.rlim_max);
    ::setrlimit(RLIMIT_AS, &memory);
#else
    static_cast<void>(memory_bytes);
#endif
}

/// If the other end is closed, no caller waits for this process, whatever the module is doing. It ends with
/// all processes that the module has started in its group. It uses a thread, because a module may not return,
/// and may block signals.
void end_with_caller(int socket) {
    std::thread([socket] {
        pollfd closed{.fd = socket, .events = 0, .revents = 0};
        while (::poll(&closed, 1, -1) < 0 && errno == EINTR) {
        }
        if ((closed.revents & POLLNVAL) == 0) ::kill(0, SIGKILL);
    }).detach();
}

double process_time_s() {
    timespec time{};
    ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Returns the parameters of the machine, which are stored in the memory as texts.
std::vector<gsim_rcs_parameter> parameters(const RcsMemory& memory) {
    std::vector<gsim_rcs_parameter> found;
    const char* text = memory.texts();
    const char* const end = text + std::min<std::size_t>(memory.shared().texts_size, memory.texts_size());
    while (text < end) {
        const char* const value = text + std::strlen(text) + 1;
        found.push_back({text, value});
        text = value + std::strlen(value) + 1;
    }
    return found;
}

class Host {
  public:
    Host(std::string path, int socket, const RcsMemory& memory)
        : path_(std::move(path)), socket_(socket), memory_(memory), shared_(memory.shared()) {}

    /// Serves requests until the end is requested.
    void serve();

  private:
    RcsQuestion next() const;
    std::int32_t answer_to(const RcsQuestion& question);
    std::int32_t load();
    std::int32_t serve(std::int32_t opcode, const void* input, void* output);
    std::int32_t call(std::int32_t opcode);
    std::int32_t call_once(std::int32_t opcode);
    std::int32_t make_steps();
    std::int32_t make_step(RcsSharedStep& step);
    bool ask_target(RcsSharedStep& step);

    std::string path_;
    int socket_;
    const RcsMemory& memory_;
    RcsShared& shared_;
    std::optional<RcsModule> module_;
    alignas(16) std::array<char, kLargestStructure> input_{};
    alignas(16) std::array<char, kLargestStructure> output_{};
};

RcsQuestion Host::next() const {
    RcsQuestion question{};
    ssize_t size = 0;
    do {
        size = ::recv(socket_, &question, sizeof question, 0);
    } while (size < 0 && errno == EINTR);
    if (size != sizeof question) ::_exit(kSocketLost);
    return question;
}

void Host::serve() {
    for (RcsQuestion question = next(); question.request != RcsRequest::end; question = next()) {
        const std::int32_t status = answer_to(question);
        shared_.serves = 0;
        const RcsAnswer answer{
            .number = question.number, .status = status, .reserved = 0, .cpu_s = process_time_s()};
        if (::send(socket_, &answer, sizeof answer, MSG_NOSIGNAL) != sizeof answer) ::_exit(kSocketLost);
    }
}

std::int32_t Host::answer_to(const RcsQuestion& question) {
    if (question.request == RcsRequest::load) return load();
    if (!module_) ::_exit(kSocketLost);
    return question.request == RcsRequest::steps ? make_steps() : call(question.opcode);
}

/// Returns 0, or 1 and a message.
std::int32_t Host::load() {
    gsim_rcs_machine machine = shared_.machine;
    const std::vector<gsim_rcs_parameter> texts = parameters(memory_);
    machine.parameters = texts.data();
    machine.parameter_count = texts.size();
    auto module =
        RcsLibrary::load_here(path_, machine).and_then([&](const std::shared_ptr<const RcsLibrary>& library) {
            return RcsModule::create(library, machine);
        });
    if (!module) {
        put_text(module.error(), shared_.output);
        return 1;
    }
    module_.emplace(*std::move(module));
    return 0;
}

/// The module cannot report its own crash, so its current service is recorded before the call.
std::int32_t Host::serve(std::int32_t opcode, const void* input, void* output) {
    shared_.serves.store(opcode, std::memory_order_relaxed);
    return module_->call(opcode, input, output);
}

/// The module gets structures of this process, so that writes beyond them do not reach the shared ones.
std::int32_t Host::call_once(std::int32_t opcode) {
    const RcsSizes sizes = rcs_sizes(opcode);
    std::memcpy(input_.data(), shared_.input.data(), sizes.input);
    std::memcpy(output_.data(), shared_.output.data(), sizes.output);
    const std::int32_t status =
        serve(opcode, sizes.input > 0 ? input_.data() : nullptr, sizes.output > 0 ? output_.data() : nullptr);
    std::memcpy(shared_.output.data(), output_.data(), sizes.output);
    return status;
}

std::int32_t Host::call(std::int32_t opcode) {
    const bool steps_if_full = shared_.ahead == static_cast<std::int32_t>(RcsAhead::if_full);
    const std::int32_t status = call_once(opcode);
    if (status != GSIM_RCS_QUEUE_FULL || !steps_if_full) return status;
    shared_.was_full = 1;
    if (make_steps() == GSIM_RCS_TARGET_REACHED) {
        shared_.retry_status = call_once(opcode);
        shared_.has_retry = 1;
    }
    return status;
}

/// True if the caller continues; it does not if the module has no such service.
bool Host::ask_target(RcsSharedStep& step) {
    gsim_rcs_target_id target = shared_.no_target;
    const std::int32_t status = serve(GSIM_RCS_GET_TARGET_OF_LAST_STEP, nullptr, &target);
    step.target = target;
    step.target_status.store(status, std::memory_order_release);
    return status == GSIM_RCS_SUCCESS;
}

std::int32_t Host::make_step(RcsSharedStep& step) {
    gsim_rcs_step made = shared_.no_step;
    step.status = serve(GSIM_RCS_GET_NEXT_STEP, nullptr, &made);
    step.step = made;
    const bool sound = step.status == GSIM_RCS_SUCCESS || step.status == GSIM_RCS_TARGET_REACHED ||
                       step.status == GSIM_RCS_NEED_MORE_DATA;
    const bool asks = sound && shared_.asks_targets != 0 && made.elapsed_s > 0;
    step.target_status = asks ? kUnanswered : kNotAsked;
    return step.status;
}

/// Returns the last status; GSIM_RCS_SUCCESS if the steps are to continue.
std::int32_t Host::make_steps() {
    const auto until = Clock::now() + kLongestAhead;
    const bool to_end = shared_.ahead == static_cast<std::int32_t>(RcsAhead::to_end);
    const bool one = shared_.ahead == static_cast<std::int32_t>(RcsAhead::nothing);
    for (std::uint32_t i = 0; i < kStepsAtOnce; ++i) {
        RcsSharedStep& step = shared_.steps[i];
        const std::int32_t status = make_step(step);
        // Must be visible before the next call, which may be the module's last.
        shared_.step_count.store(i + 1, std::memory_order_release);
        if (step.target_status == kUnanswered && !ask_target(step)) return GSIM_RCS_SUCCESS;
        const bool goes_on = status == GSIM_RCS_SUCCESS || (to_end && status == GSIM_RCS_TARGET_REACHED);
        if (!goes_on) return status;
        if (one || Clock::now() >= until) break;
    }
    return GSIM_RCS_SUCCESS;
}

int run(const std::string& path) {
    auto memory = RcsMemory::of(kHostMemory);
    // A separate descriptor for each thread, away from numbers at which a module may look for descriptors.
    const int socket = ::fcntl(kHostSocket, F_DUPFD_CLOEXEC, 64);
    const int watched = ::fcntl(kHostSocket, F_DUPFD_CLOEXEC, 64);
    if (!memory || socket < 0 || watched < 0) {
        std::fputs("gsim-rcs-host: gsim run --rcs begins this program; it is not called by people\n", stderr);
        return kUsage;
    }
    ::close(kHostSocket);
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGTTOU, SIG_IGN);  // it is in the background of the terminal that it may print to
    bound_process((*memory)->shared().memory_bytes);
    end_with_caller(watched);
    Host(path, socket, **memory).serve();
    return 0;
}

}  // namespace

}  // namespace gsim::rrs

int main(int argc, char** argv) {
    return argc == 2 ? gsim::rrs::run(argv[1]) : gsim::rrs::run({});
}

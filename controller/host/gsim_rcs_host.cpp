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

constexpr int kUsageStatus = 2;
constexpr auto kMaxPrefetchTime = std::chrono::milliseconds(100);  // of steps between two responses

/// Crashes are visible from outside as signals and use no disk space; memory use is limited.
void limit_process(std::uint64_t memory_bytes) {
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
void exit_with_caller(int socket) {
    std::thread([socket] {
        pollfd closed{.fd = socket, .events = 0, .revents = 0};
        while (::poll(&closed, 1, -1) < 0 && errno == EINTR) {
        }
        if ((closed.revents & POLLNVAL) == 0) ::kill(0, SIGKILL);
    }).detach();
}

double cpu_time_s() {
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
    RcsRequestPacket next() const;
    std::int32_t handle_request(const RcsRequestPacket& request_packet);
    std::int32_t load();
    std::int32_t serve(std::int32_t opcode, const void* input, void* output);
    std::int32_t call(std::int32_t opcode);
    std::int32_t call_once(std::int32_t opcode);
    std::int32_t make_steps();
    std::int32_t make_step(RcsSharedStep& step);
    bool query_target(RcsSharedStep& step);

    std::string path_;
    int socket_;
    const RcsMemory& memory_;
    RcsShared& shared_;
    std::optional<RcsModule> module_;
    alignas(16) std::array<char, kMaxStructureSize> input_{};
    alignas(16) std::array<char, kMaxStructureSize> output_{};
};

RcsRequestPacket Host::next() const {
    RcsRequestPacket request_packet{};
    ssize_t size = 0;
    do {
        size = ::recv(socket_, &request_packet, sizeof request_packet, 0);
    } while (size < 0 && errno == EINTR);
    if (size != sizeof request_packet) ::_exit(kSocketLost);
    return request_packet;
}

void Host::serve() {
    for (RcsRequestPacket request_packet = next(); request_packet.request != RcsRequest::end;
         request_packet = next()) {
        const std::int32_t status = handle_request(request_packet);
        shared_.active_service = 0;
        const RcsResponse response{
            .number = request_packet.number, .status = status, .reserved = 0, .cpu_s = cpu_time_s()};
        if (::send(socket_, &response, sizeof response, MSG_NOSIGNAL) != sizeof response)
            ::_exit(kSocketLost);
    }
}

std::int32_t Host::handle_request(const RcsRequestPacket& request_packet) {
    if (request_packet.request == RcsRequest::load) return load();
    if (!module_) ::_exit(kSocketLost);
    return request_packet.request == RcsRequest::steps ? make_steps() : call(request_packet.opcode);
}

/// Returns 0, or 1 and a message.
std::int32_t Host::load() {
    gsim_rcs_machine machine = shared_.machine;
    const std::vector<gsim_rcs_parameter> texts = parameters(memory_);
    machine.parameters = texts.data();
    machine.parameter_count = texts.size();
    auto module = RcsLibrary::load_in_process(path_, machine)
                      .and_then([&](const std::shared_ptr<const RcsLibrary>& library) {
                          return RcsModule::create(library, machine);
                      });
    if (!module) {
        copy_text(module.error().message, shared_.output);
        return 1;
    }
    module_.emplace(*std::move(module));
    return 0;
}

/// The module cannot report its own crash, so its current service is recorded before the call.
std::int32_t Host::serve(std::int32_t opcode, const void* input, void* output) {
    shared_.active_service.store(opcode, std::memory_order_relaxed);
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
    const bool prefetch_if_full = shared_.prefetch == static_cast<std::int32_t>(RcsPrefetch::if_full);
    const std::int32_t status = call_once(opcode);
    if (status != GSIM_RCS_QUEUE_FULL || !prefetch_if_full) return status;
    shared_.was_full = 1;
    if (make_steps() == GSIM_RCS_TARGET_REACHED) {
        shared_.retry_status = call_once(opcode);
        shared_.has_retry = 1;
    }
    return status;
}

/// True if the caller continues; it does not if the module has no such service.
bool Host::query_target(RcsSharedStep& step) {
    gsim_rcs_target_id target = shared_.empty_target;
    const std::int32_t status = serve(GSIM_RCS_GET_TARGET_OF_LAST_STEP, nullptr, &target);
    step.target = target;
    step.target_status.store(status, std::memory_order_release);
    return status == GSIM_RCS_SUCCESS;
}

std::int32_t Host::make_step(RcsSharedStep& step) {
    gsim_rcs_step module_step = shared_.empty_step;
    step.status = serve(GSIM_RCS_GET_NEXT_STEP, nullptr, &module_step);
    step.step = module_step;
    const bool is_valid_step = step.status == GSIM_RCS_SUCCESS || step.status == GSIM_RCS_TARGET_REACHED ||
                               step.status == GSIM_RCS_NEED_MORE_DATA;
    const bool queries_target = is_valid_step && shared_.queries_targets != 0 && module_step.elapsed_s > 0;
    step.target_status = queries_target ? kPending : kNotQueried;
    return step.status;
}

/// Returns the last status; GSIM_RCS_SUCCESS if the steps are to continue.
std::int32_t Host::make_steps() {
    const auto deadline = Clock::now() + kMaxPrefetchTime;
    const bool to_end = shared_.prefetch == static_cast<std::int32_t>(RcsPrefetch::to_end);
    const bool one = shared_.prefetch == static_cast<std::int32_t>(RcsPrefetch::unknown);
    for (std::uint32_t i = 0; i < kMaxPrefetchedSteps; ++i) {
        RcsSharedStep& step = shared_.steps[i];
        const std::int32_t status = make_step(step);
        // Must be visible before the next call, which may be the module's last.
        shared_.step_count.store(i + 1, std::memory_order_release);
        if (step.target_status == kPending && !query_target(step)) return GSIM_RCS_SUCCESS;
        const bool continues = status == GSIM_RCS_SUCCESS || (to_end && status == GSIM_RCS_TARGET_REACHED);
        if (!continues) return status;
        if (one || Clock::now() >= deadline) break;
    }
    return GSIM_RCS_SUCCESS;
}

int run(const std::string& path) {
    auto memory = RcsMemory::of(kHostMemory);
    // A separate descriptor for each thread, away from numbers at which a module may look for descriptors.
    const int socket = ::fcntl(kHostSocket, F_DUPFD_CLOEXEC, 64);
    const int watched_descriptor = ::fcntl(kHostSocket, F_DUPFD_CLOEXEC, 64);
    if (!memory || socket < 0 || watched_descriptor < 0) {
        std::fputs("gsim-rcs-host: gsim run --rcs starts this program; do not run it directly\n", stderr);
        return kUsageStatus;
    }
    ::close(kHostSocket);
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGTTOU, SIG_IGN);  // it is in the background of the terminal that it may print to
    limit_process((*memory)->shared().memory_bytes);
    exit_with_caller(watched_descriptor);
    Host(path, socket, **memory).serve();
    return 0;
}

}  // namespace

}  // namespace gsim::rrs

int main(int argc, char** argv) {
    return argc == 2 ? gsim::rrs::run(argv[1]) : gsim::rrs::run({});
}

#include "controller/module/rcs_link.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <new>
#include <string_view>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "base/os/spawn.h"

namespace gsim::rrs {

namespace {

constexpr int kPollInterval_ms = 100;      // interval of checks of a process that does not respond
constexpr int kShutdownTimeout_ms = 2000;  // for gsim_rcs_destroy and what the module does at exit
constexpr int kKillTimeout_ms = 1000;
constexpr int kMinDescriptor = 16;  // descriptors that dup2 to those of the host does not meet

std::string message(int error) {
    return std::generic_category().message(error);
}

os::Descriptor duplicate_descriptor(const os::Descriptor& descriptor) {
    return os::Descriptor(::fcntl(descriptor.number(), F_DUPFD_CLOEXEC, kMinDescriptor));
}

/// Returns our end and that of the host.
tl::expected<std::pair<os::Descriptor, os::Descriptor>, int> make_socket_pair(int poll_interval_ms) {
    std::array<int, 2> ends{};
    if (::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends.data()) != 0)
        return tl::unexpected(errno);
    os::Descriptor parent_end(ends[0]);
    const os::Descriptor child_end(ends[1]);
    const timeval slice{.tv_sec = poll_interval_ms / 1000,
                        .tv_usec = suseconds_t{poll_interval_ms % 1000} * 1000};
    if (::setsockopt(parent_end.number(), SOL_SOCKET, SO_RCVTIMEO, &slice, sizeof slice) != 0)
        return tl::unexpected(errno);
    os::Descriptor high = duplicate_descriptor(child_end);
    if (high.number() < 0) return tl::unexpected(errno);
    return std::pair(std::move(parent_end), std::move(high));
}

std::string machine_texts(const gsim_rcs_machine& machine) {
    std::string texts;
    for (std::size_t i = 0; i < machine.parameter_count; ++i) {
        for (const char* const text : {machine.parameters[i].key, machine.parameters[i].value})
            texts.append(text, std::strlen(text) + 1);
    }
    return texts;
}

Unexpected launch_error(const std::filesystem::path& program, int error) {
    return Unexpected(fmt::format("cannot run {}: {}", program.string(), message(error)));
}

void sleep_1_ms() {
    const timespec time{.tv_sec = 0, .tv_nsec = 1'000'000};
    ::nanosleep(&time, nullptr);
}

}  // namespace

tl::expected<std::unique_ptr<RcsMemory>, int> RcsMemory::map(os::Descriptor descriptor, std::size_t size) {
    void* const address = ::mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_SHARED, descriptor.number(), 0);
    if (address == MAP_FAILED) return tl::unexpected(errno);
    return std::unique_ptr<RcsMemory>(new RcsMemory(std::move(descriptor), address, size));
}

tl::expected<std::unique_ptr<RcsMemory>, int> RcsMemory::make(std::size_t texts_size) {
    const os::Descriptor memory_file(::memfd_create("gsim-rcs", MFD_CLOEXEC));
    if (memory_file.number() < 0) return tl::unexpected(errno);
    os::Descriptor descriptor = duplicate_descriptor(memory_file);
    const std::size_t size = sizeof(RcsShared) + texts_size;
    if (descriptor.number() < 0 || ::ftruncate(descriptor.number(), static_cast<off_t>(size)) != 0)
        return tl::unexpected(errno);
    return map(std::move(descriptor), size).map([](std::unique_ptr<RcsMemory> memory) {
        new (memory->address_) RcsShared{};
        return memory;
    });
}

tl::expected<std::unique_ptr<RcsMemory>, int> RcsMemory::of(int descriptor) {
    struct stat found {};
    if (::fstat(descriptor, &found) != 0) return tl::unexpected(errno);
    const auto size = static_cast<std::size_t>(found.st_size);
    if (size < sizeof(RcsShared)) return tl::unexpected(EINVAL);
    return map(os::Descriptor(descriptor), size);
}

RcsMemory::~RcsMemory() {
    ::munmap(address_, size_);
}

RcsLink::RcsLink(pid_t process, os::Descriptor socket, std::unique_ptr<RcsMemory> memory,
                 int response_timeout_ms)
    : process_(process),
      socket_(std::move(socket)),
      memory_(std::move(memory)),
      response_timeout_ms_(response_timeout_ms),
      poll_interval_ms_(std::min(kPollInterval_ms, response_timeout_ms)) {}

Result<std::unique_ptr<RcsLink>> RcsLink::begin(const std::filesystem::path& program, const std::string& path,
                                                const gsim_rcs_machine& machine,
                                                const RcsProcessLimits& limits) {
    const std::string texts = machine_texts(machine);
    auto memory = RcsMemory::make(texts.size());
    if (!memory) return launch_error(program, memory.error());
    RcsShared& shared = (*memory)->shared();
    shared.machine = machine;
    shared.texts_size = texts.size();
    shared.memory_bytes = limits.memory_bytes;
    std::copy(texts.begin(), texts.end(), (*memory)->texts());
    auto sockets = make_socket_pair(std::min(kPollInterval_ms, limits.response_timeout_ms));
    if (!sockets) return launch_error(program, sockets.error());
    os::SpawnActions actions;
    actions.redirect_from_null(STDIN_FILENO);
    actions.redirect(STDERR_FILENO, STDOUT_FILENO);
    actions.redirect(sockets->second.number(), kHostSocket);
    actions.redirect((*memory)->descriptor(), kHostMemory);
    const auto process = os::spawn({program.string(), path}, actions, os::ProcessGroup::separate);
    if (!process) return launch_error(program, process.error());
    return std::unique_ptr<RcsLink>(
        new RcsLink(*process, std::move(sockets->first), *std::move(memory), limits.response_timeout_ms));
}

RcsLink::~RcsLink() {
    if (!status_ && !loss_) {
        send_request(RcsRequest::end);
        wait_for_exit(kShutdownTimeout_ms);
    }
    end();
}

/// True if the process has ended; it is not reaped yet, so that no other process has its number.
bool RcsLink::has_ended() const {
    siginfo_t ended{};
    return ::waitid(P_PID, static_cast<id_t>(process_), &ended, WEXITED | WNOHANG | WNOWAIT) == 0 &&
           ended.si_pid == process_;
}

bool RcsLink::wait_for_exit(int milliseconds) const {
    for (int waited_ms = 0; waited_ms < milliseconds; ++waited_ms) {
        if (has_ended()) return true;
        sleep_1_ms();
    }
    return has_ended();
}

/// A confined program may not send signals; then the host ends once it finds that the other end is closed.
void RcsLink::end() {
    if (status_) return;
    ::kill(-process_, SIGKILL);
    socket_.close();
    int status = 0;
    if (wait_for_exit(kKillTimeout_ms) && ::waitpid(process_, &status, 0) == process_) status_ = status;
}

void RcsLink::mark_lost(std::string what, std::string reason) {
    const std::int32_t active_service = shared().active_service.load();
    loss_ =
        RcsLoss{std::move(what), std::move(reason), active_service != 0 ? active_service : pending_service_};
    end();
}

void RcsLink::mark_exited() {
    const bool has_exited = wait_for_exit(kKillTimeout_ms);
    end();
    const int status = status_.value_or(0);
    if (!has_exited || (WIFEXITED(status) && WEXITSTATUS(status) == kSocketLost)) {
        mark_lost("closed its connection", "");
    } else if (WIFSIGNALED(status)) {
        const int signal = WTERMSIG(status);
        const bool sent = signal == SIGKILL || signal == SIGTERM || signal == SIGINT || signal == SIGHUP;
        mark_lost(sent ? "was terminated" : "crashed", fmt::format(" (signal {})", signal));
    } else {
        mark_lost("ended its process", fmt::format(" (status {})", WEXITSTATUS(status)));
    }
}

/// Only the time of waiting counts: not the time while this program was stopped.
bool RcsLink::receive(RcsResponse& response) {
    std::array<char, sizeof response + 1> packet{};
    for (int waited_ms = 0;;) {
        const ssize_t size = ::recv(socket_.number(), packet.data(), packet.size(), 0);
        if (size < 0 && errno == EINTR) continue;
        if (size < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) {
            waited_ms += poll_interval_ms_;
            if (!has_ended() && waited_ms < response_timeout_ms_) continue;
            if (has_ended()) return mark_exited(), false;
            return mark_lost("did not respond", fmt::format(" within {} s", response_timeout_ms_ / 1000.0)),
                   false;
        }
        if (size <= 0) return mark_exited(), false;
        if (size == sizeof response) std::memcpy(&response, packet.data(), sizeof response);
        if (size == sizeof response && response.number == number_) return true;
        return mark_lost("closed its connection", ""), false;
    }
}

std::optional<std::int32_t> RcsLink::send_request(RcsRequest request, std::int32_t opcode) {
    if (loss_) return std::nullopt;
    const RcsRequestPacket request_packet{.number = ++number_, .request = request, .opcode = opcode};
    if (::send(socket_.number(), &request_packet, sizeof request_packet, MSG_NOSIGNAL) !=
        sizeof request_packet) {
        mark_exited();
        return std::nullopt;
    }
    if (request == RcsRequest::end) return std::nullopt;
    RcsResponse response{};
    pending_service_ = request == RcsRequest::steps ? std::int32_t{GSIM_RCS_GET_NEXT_STEP} : opcode;
    if (!receive(response)) return std::nullopt;
    pending_service_ = 0;
    cpu_s_ = response.cpu_s;
    return response.status;
}

}  // namespace gsim::rrs

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

constexpr int kSlice_ms = 100;      // interval of checks of a process that does not respond
constexpr int kFarewell_ms = 2000;  // for gsim_rcs_destroy and what the module does at exit
constexpr int kDeath_ms = 1000;
constexpr int kAboveFixed = 16;  // descriptors that dup2 to those of the host does not meet

std::string message(int error) {
    return std::generic_category().message(error);
}

os::Descriptor lifted(const os::Descriptor& descriptor) {
    return os::Descriptor(::fcntl(descriptor.number(), F_DUPFD_CLOEXEC, kAboveFixed));
}

/// Returns our end and that of the host.
tl::expected<std::pair<os::Descriptor, os::Descriptor>, int> make_sockets(int slice_ms) {
    std::array<int, 2> ends{};
    if (::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends.data()) != 0)
        return tl::unexpected(errno);
    os::Descriptor ours(ends[0]);
    const os::Descriptor theirs(ends[1]);
    const timeval slice{.tv_sec = slice_ms / 1000, .tv_usec = suseconds_t{slice_ms % 1000} * 1000};
    if (::setsockopt(ours.number(), SOL_SOCKET, SO_RCVTIMEO, &slice, sizeof slice) != 0)
        return tl::unexpected(errno);
    os::Descriptor high = lifted(theirs);
    if (high.number() < 0) return tl::unexpected(errno);
    return std::pair(std::move(ours), std::move(high));
}

std::string texts_of(const gsim_rcs_machine& machine) {
    std::string texts;
    for (std::size_t i = 0; i < machine.parameter_count; ++i) {
        for (const char* const text : {machine.parameters[i].key, machine.parameters[i].value})
            texts.append(text, std::strlen(text) + 1);
    }
    return texts;
}

tl::unexpected<std::string> cannot(const std::filesystem::path& program, int error) {
    return tl::unexpected(fmt::format("cannot run {}: {}", program.string(), message(error)));
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
    const os::Descriptor made(::memfd_create("gsim-rcs", MFD_CLOEXEC));
    if (made.number() < 0) return tl::unexpected(errno);
    os::Descriptor descriptor = lifted(made);
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

RcsLink::RcsLink(pid_t process, os::Descriptor socket, std::unique_ptr<RcsMemory> memory, int answer_ms)
    : process_(process),
      socket_(std::move(socket)),
      memory_(std::move(memory)),
      answer_ms_(answer_ms),
      slice_ms_(std::min(kSlice_ms, answer_ms)) {}

tl::expected<std::unique_ptr<RcsLink>, std::string> RcsLink::begin(const std::filesystem::path& program,
                                                                   const std::string& path,
                                                                   const gsim_rcs_machine& machine,
                                                                   const RcsProcessLimits& limits) {
    const std::string texts = texts_of(machine);
    auto memory = RcsMemory::make(texts.size());
    if (!memory) return cannot(program, memory.error());
    RcsShared& shared = (*memory)->shared();
    shared.machine = machine;
    shared.texts_size = texts.size();
    shared.memory_bytes = limits.memory_bytes;
    std::copy(texts.begin(), texts.end(), (*memory)->texts());
    auto sockets = make_sockets(std::min(kSlice_ms, limits.answer_ms));
    if (!sockets) return cannot(program, sockets.error());
    os::SpawnActions actions;
    actions.read_nothing(STDIN_FILENO);
    actions.redirect(STDERR_FILENO, STDOUT_FILENO);
    actions.redirect(sockets->second.number(), kHostSocket);
    actions.redirect((*memory)->descriptor(), kHostMemory);
    const auto process = os::spawn({program.string(), path}, actions, os::ProcessGroup::own);
    if (!process) return cannot(program, process.error());
    return std::unique_ptr<RcsLink>(
        new RcsLink(*process, std::move(sockets->first), *std::move(memory), limits.answer_ms));
}

RcsLink::~RcsLink() {
    if (!status_ && !loss_) {
        ask(RcsRequest::end);
        wait_for_end(kFarewell_ms);
    }
    end();
}

/// True if the process has ended; it is not reaped yet, so that no other process has its number.
bool RcsLink::has_ended() const {
    siginfo_t ended{};
    return ::waitid(P_PID, static_cast<id_t>(process_), &ended, WEXITED | WNOHANG | WNOWAIT) == 0 &&
           ended.si_pid == process_;
}

bool RcsLink::wait_for_end(int milliseconds) const {
    for (int waited_ms = 0; waited_ms < milliseconds; ++waited_ms) {
        if (has_ended()) return true;
        sleep_1_ms();
    }
    return has_ended();
}

/// A confined program may not send signals; then the host ends after it finds that the other end is closed.
void RcsLink::end() {
    if (status_) return;
    ::kill(-process_, SIGKILL);
    socket_.close();
    int status = 0;
    if (wait_for_end(kDeath_ms) && ::waitpid(process_, &status, 0) == process_) status_ = status;
}

void RcsLink::lose(std::string what, std::string why) {
    const std::int32_t serves = shared().serves.load();
    loss_ = RcsLoss{std::move(what), std::move(why), serves != 0 ? serves : awaited_};
    end();
}

void RcsLink::lose_ended() {
    const bool by_itself = wait_for_end(kDeath_ms);
    end();
    const int status = status_.value_or(0);
    if (!by_itself || (WIFEXITED(status) && WEXITSTATUS(status) == kSocketLost)) {
        lose("broke its connection", "");
    } else if (WIFSIGNALED(status)) {
        const int signal = WTERMSIG(status);
        const bool sent = signal == SIGKILL || signal == SIGTERM || signal == SIGINT || signal == SIGHUP;
        lose(sent ? "was ended" : "crashed", fmt::format(" (signal {})", signal));
    } else {
        lose("ended its process", fmt::format(" (status {})", WEXITSTATUS(status)));
    }
}

/// Only the time of waiting counts: not the time while this program was stopped.
bool RcsLink::receive(RcsAnswer& answer) {
    std::array<char, sizeof answer + 1> packet{};
    for (int waited_ms = 0;;) {
        const ssize_t size = ::recv(socket_.number(), packet.data(), packet.size(), 0);
        if (size < 0 && errno == EINTR) continue;
        if (size < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) {
            waited_ms += slice_ms_;
            if (!has_ended() && waited_ms < answer_ms_) continue;
            if (has_ended()) return lose_ended(), false;
            return lose("gave no answer", fmt::format(" within {} s", answer_ms_ / 1000.0)), false;
        }
        if (size <= 0) return lose_ended(), false;
        if (size == sizeof answer) std::memcpy(&answer, packet.data(), sizeof answer);
        if (size == sizeof answer && answer.number == number_) return true;
        return lose("broke its connection", ""), false;
    }
}

std::optional<std::int32_t> RcsLink::ask(RcsRequest request, std::int32_t opcode) {
    if (loss_) return std::nullopt;
    const RcsQuestion question{.number = ++number_, .request = request, .opcode = opcode};
    if (::send(socket_.number(), &question, sizeof question, MSG_NOSIGNAL) != sizeof question) {
        lose_ended();
        return std::nullopt;
    }
    if (request == RcsRequest::end) return std::nullopt;
    RcsAnswer answer{};
    awaited_ = request == RcsRequest::steps ? std::int32_t{GSIM_RCS_GET_NEXT_STEP} : opcode;
    if (!receive(answer)) return std::nullopt;
    awaited_ = 0;
    cpu_s_ = answer.cpu_s;
    return answer.status;
}

}  // namespace gsim::rrs

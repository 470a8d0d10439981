#include "studio/server/engine_process.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/os/spawn.h"

namespace gsim::studio {

namespace {

constexpr std::size_t kPiece = std::size_t{256} << 10U;

std::string reason(int error) {
    return std::generic_category().message(error);
}

/// Returns a request as a file in memory, so that a slow reader does not block other code. The error is
/// errno.
tl::expected<os::Descriptor, int> text_file(std::string_view text) {
    os::Descriptor file(::memfd_create("asked", MFD_CLOEXEC));
    if (file.number() < 0) return tl::unexpected(errno);
    while (!text.empty()) {
        const ssize_t written = ::write(file.number(), text.data(), text.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return tl::unexpected(errno);
        text.remove_prefix(static_cast<std::size_t>(written));
    }
    if (::lseek(file.number(), 0, SEEK_SET) != 0) return tl::unexpected(errno);
    return file;
}

}  // namespace

Result<EngineProcess> EngineProcess::begin(const std::vector<std::string>& command,
                                           std::string_view request_text, int kept) {
    const auto input = text_file(request_text);
    std::array<int, 2> ends{};
    if (!input || ::pipe2(ends.data(), O_CLOEXEC) != 0)
        return Unexpected("the engine cannot be started: " + reason(input ? errno : input.error()));
    os::Descriptor output(ends[0]);
    const os::Descriptor child_end(ends[1]);
    os::SpawnActions actions;
    actions.redirect(input->number(), STDIN_FILENO);
    actions.redirect(child_end.number(), STDOUT_FILENO);
    if (kept >= 0) actions.redirect(kept, kFileDescriptor);
    const auto child = os::spawn(command, actions);
    if (!child) return Unexpected("the engine cannot be started: " + reason(child.error()));
    return EngineProcess(*child, std::move(output));
}

EngineProcess::EngineProcess(EngineProcess&& other) noexcept
    : child_(std::exchange(other.child_, -1)), output_(std::move(other.output_)) {}

EngineProcess::~EngineProcess() {
    if (child_ < 0) return;
    ::kill(child_, SIGKILL);
    os::wait_for(child_);
}

std::optional<std::string> EngineProcess::read(int timeout_ms) {
    pollfd request_text{output_.number(), POLLIN, 0};
    const int ready = ::poll(&request_text, 1, timeout_ms);
    if (ready <= 0) return std::string();
    std::string chunk(kPiece, '\0');
    const ssize_t bytes_read = ::read(output_.number(), chunk.data(), chunk.size());
    if (bytes_read < 0 && errno == EINTR) return std::string();
    if (bytes_read <= 0) return std::nullopt;
    chunk.resize(static_cast<std::size_t>(bytes_read));
    return chunk;
}

std::string EngineProcess::error() {
    const auto status = os::wait_for(std::exchange(child_, -1));
    if (!status) return "the connection to the engine was lost: " + reason(status.error());
    if (WIFSIGNALED(*status)) return fmt::format("the engine was terminated by signal {}", WTERMSIG(*status));
    if (WEXITSTATUS(*status) == 0) return {};
    return fmt::format("the engine ended with status {}", WEXITSTATUS(*status));
}

}  // namespace gsim::studio

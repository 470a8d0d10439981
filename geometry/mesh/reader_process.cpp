#include "geometry/mesh/reader_process.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <system_error>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/os/descriptor.h"
#include "base/os/installation.h"
#include "base/os/spawn.h"
#include "geometry/mesh/packet.h"

namespace gsim::solid {

namespace {

constexpr std::uintmax_t kMaxBytes = 256ULL << 20U;
constexpr bool kHasReader = GSIM_HAS_OPENCASCADE != 0;

std::string message(int error) {
    return std::generic_category().message(error);
}

Result<std::filesystem::path> reader_program() {
    return os::helper_program(os::program_folder(), "gsim-solid").map_error([](const Error& error) {
        return Error(error.message + "; it reads STEP and IGES files");
    });
}

Result<void> check_file(const std::filesystem::path& file) {
    std::error_code error;
    const auto status = std::filesystem::status(file, error);
    if (error) return Unexpected(fmt::format("cannot read '{}': {}", file.string(), error.message()));
    if (!std::filesystem::is_regular_file(status))
        return Unexpected(fmt::format("cannot read '{}': it is not a regular file", file.string()));
    const std::uintmax_t size = std::filesystem::file_size(file, error);
    if (error) return Unexpected(fmt::format("cannot read '{}': {}", file.string(), error.message()));
    if (size > kMaxBytes)
        return Unexpected(fmt::format("'{}' is larger than {} MiB", file.string(), kMaxBytes >> 20U));
    return {};
}

std::string read_to_end(int descriptor) {
    std::string bytes;
    std::array<char, 1U << 16U> chunk{};
    while (true) {
        const ssize_t count = ::read(descriptor, chunk.data(), chunk.size());
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) return bytes;
        bytes.append(chunk.data(), static_cast<std::size_t>(count));
    }
}

// Returns why a reader ended without a result.
std::string exit_reason(int status) {
    if (!WIFSIGNALED(status)) return fmt::format("OpenCASCADE ended with status {}", WEXITSTATUS(status));
    if (WTERMSIG(status) == SIGXCPU) return "OpenCASCADE exceeded its time limit";
    return fmt::format("OpenCASCADE crashed (signal {}); the file is damaged, or too large for the memory",
                       WTERMSIG(status));
}

}  // namespace

Result<std::string> query_reader(const std::string& request, const std::filesystem::path& file,
                                 const std::vector<std::string>& settings) {
    if (!kHasReader) {
        return Unexpected(
            fmt::format("'{}': this build does not read STEP and IGES files; install OpenCASCADE "
                        "(scripts/setup.sh step), then build again with -DGSIM_OPENCASCADE=ON",
                        file.string()));
    }
    if (const auto checked = check_file(file); !checked) return Unexpected(checked.error());
    const auto program = reader_program();
    if (!program) return Unexpected(program.error());
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0)
        return Unexpected(fmt::format("cannot create a pipe: {}", message(errno)));
    const os::Descriptor input(ends[0]);
    os::Descriptor output(ends[1]);
    std::vector<std::string> command{program->string(), request, std::filesystem::absolute(file).string()};
    command.insert(command.end(), settings.begin(), settings.end());
    os::SpawnActions actions;
    actions.redirect_from_null(STDIN_FILENO);
    actions.redirect(output.number(), STDOUT_FILENO);
    const auto child = os::spawn(command, actions);
    if (!child) return Unexpected(fmt::format("cannot run {}: {}", command[0], message(child.error())));
    output.close();
    std::string response = read_to_end(input.number());
    const auto status = os::wait_for(*child);
    if (!status)
        return Unexpected(fmt::format("cannot wait for {}: {}", command[0], message(status.error())));
    if (!WIFEXITED(*status) || WEXITSTATUS(*status) != 0 || response.empty())
        return Unexpected(fmt::format("'{}' cannot be read: {}", file.string(), exit_reason(*status)));
    PacketReader packet(response);
    if (packet.read_flag()) return response.substr(1);
    return Unexpected(fmt::format("{}: {}", file.string(), packet.read_text()));
}

}  // namespace gsim::solid

#include "base/os/child_process.h"

#include <cerrno>
#include <system_error>

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/os/file_handle.h"
#include "base/os/memory_file.h"
#include "base/os/spawn.h"

namespace gsim::os {

namespace {

std::string message(int error) {
    return std::generic_category().message(error);
}

std::string first_line(std::FILE* file) {
    std::rewind(file);
    std::string line;
    for (int c = std::fgetc(file); c != EOF && line.size() < 200; c = std::fgetc(file)) {
        if (c == '\n' && !line.empty()) break;
        if (c >= 0x20 && c != 0x7f) line += static_cast<char>(c);
    }
    return line;
}

}  // namespace

Result<void> run_child(const std::vector<std::string>& command, std::FILE* input, std::FILE* output) {
    const FileHandle errors = open_memory_file("errors");
    if (!errors) return Unexpected("cannot create a file in memory: " + message(errno));
    SpawnActions actions;
    actions.redirect(::fileno(input), STDIN_FILENO);
    actions.redirect(::fileno(output), STDOUT_FILENO);
    actions.redirect(::fileno(errors.get()), STDERR_FILENO);
    const auto child = spawn(command, actions);
    if (!child) return Unexpected(fmt::format("cannot run {}: {}", command[0], message(child.error())));
    const auto status = wait_for(*child);
    if (!status)
        return Unexpected(fmt::format("cannot wait for {}: {}", command[0], message(status.error())));
    if (WIFEXITED(*status) && WEXITSTATUS(*status) == 0) return {};
    if (WIFSIGNALED(*status))
        return Unexpected(fmt::format("{} was terminated by signal {}", command[0], WTERMSIG(*status)));
    return Unexpected(fmt::format("{} failed: {}", command[0], first_line(errors.get())));
}

}  // namespace gsim::os

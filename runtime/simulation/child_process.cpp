#include "runtime/simulation/child_process.h"

#include <cerrno>
#include <memory>
#include <system_error>

#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace gsim::simulation {

namespace {

struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

class SpawnActions {
  public:
    SpawnActions() { ::posix_spawn_file_actions_init(&actions_); }
    SpawnActions(const SpawnActions&) = delete;
    SpawnActions& operator=(const SpawnActions&) = delete;
    ~SpawnActions() { ::posix_spawn_file_actions_destroy(&actions_); }

    void redirect(std::FILE* file, int descriptor) {
        ::posix_spawn_file_actions_adddup2(&actions_, ::fileno(file), descriptor);
    }
    const posix_spawn_file_actions_t* get() const { return &actions_; }

  private:
    posix_spawn_file_actions_t actions_;
};

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

tl::expected<pid_t, int> spawn(const std::vector<std::string>& command, const SpawnActions& actions) {
    std::vector<char*> arguments;
    arguments.reserve(command.size() + 1);
    for (const std::string& argument : command) arguments.push_back(const_cast<char*>(argument.c_str()));
    arguments.push_back(nullptr);
    pid_t child = 0;
    const int error = ::posix_spawnp(&child, arguments[0], actions.get(), nullptr, arguments.data(), environ);
    if (error != 0) return tl::unexpected(error);
    return child;
}

}  // namespace

tl::expected<void, std::string> run_child(const std::vector<std::string>& command, std::FILE* input,
                                          std::FILE* output) {
    const File errors(std::tmpfile());
    if (!errors) return tl::unexpected("cannot make a temporary file: " + message(errno));
    SpawnActions actions;
    actions.redirect(input, STDIN_FILENO);
    actions.redirect(output, STDOUT_FILENO);
    actions.redirect(errors.get(), STDERR_FILENO);
    const auto child = spawn(command, actions);
    if (!child) return tl::unexpected(fmt::format("cannot run {}: {}", command[0], message(child.error())));
    int status = 0;
    while (::waitpid(*child, &status, 0) < 0) {
        if (errno != EINTR) return tl::unexpected(fmt::format("lost {}: {}", command[0], message(errno)));
    }
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return {};
    return tl::unexpected(fmt::format("{} failed: {}", command[0], first_line(errors.get())));
}

}  // namespace gsim::simulation

#include "bench/measure.h"

#include <cerrno>
#include <system_error>

#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>

extern char** environ;

namespace gsim::bench {
namespace {

/// Redirection of the child's standard input and output to /dev/null.
class OutputRedirection {
  public:
    OutputRedirection() {
        posix_spawn_file_actions_init(&actions_);
        posix_spawn_file_actions_addopen(&actions_, 0, "/dev/null", O_RDONLY, 0);
        posix_spawn_file_actions_addopen(&actions_, 1, "/dev/null", O_WRONLY, 0);
    }
    ~OutputRedirection() { posix_spawn_file_actions_destroy(&actions_); }
    OutputRedirection(const OutputRedirection&) = delete;
    OutputRedirection& operator=(const OutputRedirection&) = delete;
    [[nodiscard]] const posix_spawn_file_actions_t* get() const { return &actions_; }

  private:
    posix_spawn_file_actions_t actions_{};
};

double seconds(const timeval& time) {
    return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) * 1e-6;
}

int exit_status(int wait_status) {
    return WIFSIGNALED(wait_status) ? 128 + WTERMSIG(wait_status) : WEXITSTATUS(wait_status);
}

}  // namespace

Usage measure(const std::vector<std::string>& command) {
    std::vector<std::string> words = command;
    std::vector<char*> argv;
    argv.reserve(words.size() + 1);
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);

    pid_t child = 0;
    const OutputRedirection redirection;
    const int error = posix_spawnp(&child, argv[0], redirection.get(), nullptr, argv.data(), environ);
    if (error == ENOENT || error == EACCES) return {.status = 127};
    if (error != 0)
        throw std::system_error(error, std::generic_category(), "cannot start " + command.front());

    int wait_status = 0;
    rusage measured{};
    while (wait4(child, &wait_status, 0, &measured) < 0) {
        if (errno != EINTR) throw std::system_error(errno, std::generic_category(), "wait4");
    }
    return {seconds(measured.ru_utime) + seconds(measured.ru_stime),
            static_cast<double>(measured.ru_maxrss) * 1024.0 / 1e6, exit_status(wait_status)};
}

}  // namespace gsim::bench

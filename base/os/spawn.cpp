#include "base/os/spawn.h"

#include <cerrno>

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace gsim::os {

namespace {

/// The signals and the group of a process that is started.
class SpawnAttributes {
  public:
    explicit SpawnAttributes(ProcessGroup group) {
        ::posix_spawnattr_init(&attributes_);
        sigset_t none;
        sigemptyset(&none);
        ::posix_spawnattr_setsigmask(&attributes_, &none);
        sigset_t default_signals = none;
        sigaddset(&default_signals, SIGPIPE);
        ::posix_spawnattr_setsigdefault(&attributes_, &default_signals);
        ::posix_spawnattr_setpgroup(&attributes_, 0);  // a group with its own number
        const int separate = group == ProcessGroup::separate ? POSIX_SPAWN_SETPGROUP : 0;
        ::posix_spawnattr_setflags(
            &attributes_, static_cast<short>(POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | separate));
    }
    SpawnAttributes(const SpawnAttributes&) = delete;
    SpawnAttributes& operator=(const SpawnAttributes&) = delete;
    ~SpawnAttributes() { ::posix_spawnattr_destroy(&attributes_); }

    const posix_spawnattr_t* get() const { return &attributes_; }

  private:
    posix_spawnattr_t attributes_{};
};

}  // namespace

void SpawnActions::redirect_from_null(int descriptor) {
    ::posix_spawn_file_actions_addopen(&actions_, descriptor, "/dev/null", O_RDONLY, 0);
}

tl::expected<pid_t, int> spawn(const std::vector<std::string>& command, const SpawnActions& actions,
                               ProcessGroup group) {
    std::vector<char*> arguments;
    arguments.reserve(command.size() + 1);
    for (const std::string& argument : command) arguments.push_back(const_cast<char*>(argument.c_str()));
    arguments.push_back(nullptr);
    const SpawnAttributes attributes(group);
    pid_t child = 0;
    const int error =
        ::posix_spawnp(&child, arguments[0], actions.get(), attributes.get(), arguments.data(), environ);
    if (error != 0) return tl::unexpected(error);
    return child;
}

tl::expected<int, int> wait_for(pid_t child) {
    int status = 0;
    while (::waitpid(child, &status, 0) < 0) {
        if (errno != EINTR) return tl::unexpected(errno);
    }
    return status;
}

}  // namespace gsim::os

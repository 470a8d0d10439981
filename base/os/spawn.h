#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <spawn.h>
#include <sys/types.h>
#include <tl/expected.hpp>

namespace gsim::os {

/// Changes to the descriptors of a process that is started.
class SpawnActions {
  public:
    SpawnActions() { ::posix_spawn_file_actions_init(&actions_); }
    SpawnActions(const SpawnActions&) = delete;
    SpawnActions& operator=(const SpawnActions&) = delete;
    ~SpawnActions() { ::posix_spawn_file_actions_destroy(&actions_); }

    /// Makes `descriptor` in the child what `inherited` is here.
    void redirect(int inherited, int descriptor) {
        ::posix_spawn_file_actions_adddup2(&actions_, inherited, descriptor);
    }
    /// Gives the child no data to read from `descriptor`.
    void redirect_from_null(int descriptor);
    const posix_spawn_file_actions_t* get() const { return &actions_; }

  private:
    posix_spawn_file_actions_t actions_{};
};

/// Process group of a started process. It decides if signals of a terminal to all processes started there
/// (Ctrl+C) reach it.
enum class ProcessGroup : std::uint8_t { inherited, separate };

/// Starts a process: a program, searched in PATH unless its name has a slash, and its arguments. In the child
/// no signal is blocked, and SIGPIPE ends it, whatever holds here. Other signals that are ignored here
/// (nohup) are ignored there. The error is that of errno.
tl::expected<pid_t, int> spawn(const std::vector<std::string>& command, const SpawnActions& actions,
                               ProcessGroup group = ProcessGroup::inherited);

/// Waits until a child ends and returns its status as of waitpid(), or errno.
tl::expected<int, int> wait_for(pid_t child);

}  // namespace gsim::os

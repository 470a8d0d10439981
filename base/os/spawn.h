#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <spawn.h>
#include <sys/types.h>
#include <tl/expected.hpp>

namespace gsim::os {

/// What becomes of the descriptors of a process that is begun.
class SpawnActions {
  public:
    SpawnActions() { ::posix_spawn_file_actions_init(&actions_); }
    SpawnActions(const SpawnActions&) = delete;
    SpawnActions& operator=(const SpawnActions&) = delete;
    ~SpawnActions() { ::posix_spawn_file_actions_destroy(&actions_); }

    /// In the child `descriptor` is what `ours` is here.
    void redirect(int ours, int descriptor) {
        ::posix_spawn_file_actions_adddup2(&actions_, ours, descriptor);
    }
    /// In the child there is nothing to read from `descriptor`.
    void read_nothing(int descriptor);
    const posix_spawn_file_actions_t* get() const { return &actions_; }

  private:
    posix_spawn_file_actions_t actions_{};
};

/// Whether what a terminal sends to all that was begun there (Ctrl+C) reaches a process that is begun.
enum class ProcessGroup : std::uint8_t { ours, own };

/// Begins a process: a program, looked for in PATH unless its name has a slash, and its arguments. No signal
/// is blocked in it, and SIGPIPE ends it, whatever holds here; other signals that are ignored here (nohup)
/// are so there. The error is that of errno.
tl::expected<pid_t, int> spawn(const std::vector<std::string>& command, const SpawnActions& actions,
                               ProcessGroup group = ProcessGroup::ours);

/// Waits until a child ends; its status as of waitpid(), or errno.
tl::expected<int, int> wait_for(pid_t child);

}  // namespace gsim::os

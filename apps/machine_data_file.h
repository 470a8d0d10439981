#pragma once

#include <string>
#include <string_view>

#include "base/error.h"
#include "base/os/file_lock.h"
#include "cli/command_line.h"

namespace gsim::apps {

/// Default for the longest wait for a file that another program is changing.
inline constexpr double kMaxWait_s = 10;

/// Adds --wait.
void add_wait_option(CommandLine& line, double& wait_s);

/// Locks a file that the caller reads, changes and writes back. Until it is written no other program does the
/// same.
Result<os::FileLock> lock_for_change(const std::string& path, double wait_s);

/// Writes a locked file so that at each moment either the complete old or the complete new one exists, even
/// if the power fails. It writes a temporary file in the same folder, flushes it to the disk and renames it.
/// Permissions are kept; if the name is a symbolic link, its target is replaced.
Result<void> save_text(const std::string& path, std::string_view text);

/// Does the same for a file that was not read, and is locked while it is written.
Result<void> replace_text(const std::string& path, std::string_view text, double wait_s);

}  // namespace gsim::apps

#pragma once

#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include "base/os/file_lock.h"
#include "cli/command_line.h"

namespace gsim::apps {

/// How long a file that another program is changing is waited for where nothing else is said.
inline constexpr double kLongestWait_s = 10;

/// --wait.
void add_wait_option(CommandLine& line, double& wait_s);

/// For who reads a file, changes it and writes it back: from before the reading until it is written nobody
/// else does so. The error is a sentence.
tl::expected<os::FileLock, std::string> lock_to_change(const std::string& path, double wait_s);

/// Writes a file that is locked so that at each moment either the old one or the new one stands there whole,
/// also when the power fails: beside it, to the disk, then renamed. Permissions stay; where the name is a
/// symbolic link, its target is replaced. The error is a sentence.
tl::expected<void, std::string> save_text(const std::string& path, std::string_view text);

/// The same for a file that was not read, and is locked while it is written.
tl::expected<void, std::string> replace_text(const std::string& path, std::string_view text, double wait_s);

}  // namespace gsim::apps

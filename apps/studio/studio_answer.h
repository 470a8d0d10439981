#pragma once

#include <span>
#include <string>

namespace gsim::apps {

/// Answers one thing that a page of gsim-studio asks for: {"request", "files", "binary"} on standard input
/// (docs/studio.md), messages on standard output. Files are those given there, then those of the folder, then
/// the samples of the installation. `arguments`: "--folder FOLDER", and "--rcs MODULE" where one plans. The
/// exit status.
int answer_studio(std::span<const std::string> arguments);

}  // namespace gsim::apps

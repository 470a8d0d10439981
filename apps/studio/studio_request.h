#pragma once

#include <span>
#include <string>

namespace gsim::apps {

/// Processes one request of a page of gsim-studio: {"request", "files", "binary"} on standard input
/// (docs/studio.md), messages on standard output. Files are those given there, then those of the folder, then
/// the samples of the installation. `arguments`: "--folder FOLDER", and "--rcs MODULE" if a module does the
/// planning. Returns the exit status.
int handle_studio_request(std::span<const std::string> arguments);

}  // namespace gsim::apps

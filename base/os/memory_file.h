#pragma once

#include "base/os/file_handle.h"

namespace gsim::os {

/// Returns a nameless file in memory, for writing and reading, or null with errno if the system provides
/// none. `name` is shown to those who inspect the process.
FileHandle open_memory_file(const char* name);

}  // namespace gsim::os

#pragma once

#include "base/os/file_handle.h"

namespace gsim::os {

/// A nameless file in memory, to be written and read; null with errno where the system gives none. `name` is
/// for those who look at the process.
FileHandle file_in_memory(const char* name);

}  // namespace gsim::os

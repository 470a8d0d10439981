#pragma once

#include <cstdio>
#include <string>
#include <vector>

#include "base/error.h"

namespace gsim::os {

/// Runs a program (found by PATH; no shell in between) from `input` to `output`, both files, and waits for
/// its end. The error is a message: the program cannot be started, or how it failed, with the first line that
/// it wrote to standard error.
Result<void> run_child(const std::vector<std::string>& command, std::FILE* input, std::FILE* output);

}  // namespace gsim::os

#pragma once

#include <functional>
#include <string>

#include "base/error.h"

namespace gsim::rrs {

/// Runs `work` in a child process and returns its result, so that a crash in it affects only the child. The
/// error continues a message: "crashed (signal 11)", "ended the program", "gave no answer within 10 s".
Result<std::string> run_trial(const std::function<std::string()>& work, int timeout_ms);

}  // namespace gsim::rrs

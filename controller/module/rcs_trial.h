#pragma once

#include <functional>
#include <string>

#include <tl/expected.hpp>

namespace gsim::rrs {

/// Does `work` in a child process and returns what it says, so that a crash in it is one of the child alone.
/// The error continues a sentence: "crashed (signal 11)", "ended the program", "gave no answer within 10 s".
tl::expected<std::string, std::string> run_trial(const std::function<std::string()>& work, int timeout_ms);

}  // namespace gsim::rrs

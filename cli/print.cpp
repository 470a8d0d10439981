#include "cli/print.h"

#include <cerrno>
#include <cstdio>
#include <system_error>

#include <fmt/format.h>

#include "cli/exit_status.h"

namespace gsim::apps {

namespace {

void tell_failure(int error) {
    const std::string sentence =
        fmt::format("cannot write standard output: {}\n", std::generic_category().message(error));
    tell(sentence);
}

}  // namespace

// The stream's own error flag means that the error was already reported.
void print(std::string_view text) {
    if (std::ferror(stdout) != 0) return;
    const bool whole = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
    if (!whole || std::ferror(stdout) != 0) tell_failure(errno);
}

void tell(std::string_view text) {
    static_cast<void>(std::fwrite(text.data(), 1, text.size(), stderr));
}

int finish_standard_output(int status) {
    const bool told = std::ferror(stdout) != 0;
    // Some systems report a full disk or a lost server only when the file is closed.
    const bool closed = std::fclose(stdout) == 0;
    if (!closed && !told) tell_failure(errno);
    return (told || !closed) && status == kDone ? kUsage : status;
}

}  // namespace gsim::apps

#include "cli/print.h"

#include <cerrno>
#include <cstdio>
#include <system_error>

#include <fmt/format.h>

#include "cli/exit_status.h"

namespace gsim::apps {

namespace {

void report_write_error(int error) {
    const std::string message =
        fmt::format("cannot write standard output: {}\n", std::generic_category().message(error));
    print_to_standard_error(message);
}

}  // namespace

// The stream's own error flag means that the error was already reported.
void print(std::string_view text) {
    if (std::ferror(stdout) != 0) return;
    const bool is_complete = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
    if (!is_complete || std::ferror(stdout) != 0) report_write_error(errno);
}

void print_to_standard_error(std::string_view text) {
    static_cast<void>(std::fwrite(text.data(), 1, text.size(), stderr));
}

int finish_standard_output(int status) {
    const bool has_failed = std::ferror(stdout) != 0;
    // Some systems report a full disk or a lost server only when the file is closed.
    const bool closed = std::fclose(stdout) == 0;
    if (!closed && !has_failed) report_write_error(errno);
    return (has_failed || !closed) && status == kSuccess ? kUsageError : status;
}

}  // namespace gsim::apps

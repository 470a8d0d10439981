#include "calibrate/command.h"

#include <cstdio>

#include <fmt/format.h>

#include "apps/parse.h"
#include "base/os/output_file.h"

namespace gsim::calibrate {

int run_command(const apps::CommandLine& line, const std::vector<std::string>& words,
                const std::function<Done()>& command) {
    constexpr int kGood = 0, kFailed = 1, kUsage = 2;
    const auto parsed = apps::parse(line, words);
    if (!parsed) {
        fmt::print(stderr, "gsim-calibrate: {}\n", parsed.error());
        return kUsage;
    }
    if (*parsed) return **parsed;
    if (const auto done = command(); !done) {
        fmt::print(stderr, "gsim-calibrate: {}\n", done.error());
        return kFailed;
    }
    return kGood;
}

Done write_if(const std::string& file, const std::string& text) {
    if (file.empty()) return {};
    return os::write_file(file, text);
}

Done write_or_print(const std::string& file, const std::string& text) {
    if (!file.empty()) return os::write_file(file, text);
    std::fwrite(text.data(), 1, text.size(), stdout);
    if (std::fflush(stdout) != 0) return tl::unexpected<std::string>("cannot write standard output");
    return {};
}

}  // namespace gsim::calibrate

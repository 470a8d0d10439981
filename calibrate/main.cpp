// gsim-calibrate: determines a machine file from recordings of a machine.

#include <exception>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "calibrate/geometry_command.h"
#include "calibrate/servo_command.h"
#include "calibrate/times_command.h"
#include "cli/exit_status.h"
#include "cli/help_text.h"
#include "cli/named_files.h"
#include "cli/parse.h"
#include "cli/print.h"
#include "cli/standalone_pages.h"
#include "cli/usage_error.h"

namespace gsim::calibrate {

namespace {

constexpr const char* kName = "gsim-calibrate";

int report_usage_error(const std::string& message) {
    apps::report_error(kName, message);
    return apps::usage_error(kName, fmt::format("see {} --help", kName));
}

int run(const std::vector<std::string>& words) {
    apps::CommandLine line(kName,
                           "Creates a machine file from measurements: recorded runs, TCP positions, or set "
                           "points and actual positions of axes");
    SelectedCommand selected;
    add_times_command(line, selected);
    add_geometry_command(line, selected);
    add_servo_command(line, selected);
    const std::vector<std::string> others{"gsim", "gsim-run", "gsim-check"};
    if (const auto printed = apps::print_standalone_pages(line, words, others)) return *printed;
    if (words.empty()) {
        apps::print(apps::help_text(line, &line));
        return apps::kUsageError;
    }
    const auto parsed = apps::parse(line, words);
    if (!parsed) return report_usage_error(parsed.error().message);
    if (*parsed) return **parsed;
    if (const auto conflict = apps::find_file_conflict(line)) return report_usage_error(conflict->message);
    if (const Result<void> done = selected(); !done) {
        apps::report_error(kName, done.error().message);
        return apps::kProgramError;
    }
    return apps::kSuccess;
}

}  // namespace

}  // namespace gsim::calibrate

int main(int argc, char** argv) {
    try {
        return gsim::apps::finish_standard_output(
            gsim::calibrate::run(std::vector<std::string>(argv + 1, argv + argc)));
    } catch (const std::exception& error) {
        gsim::apps::report_error("gsim-calibrate", error.what());
        return gsim::apps::kProgramError;
    }
}

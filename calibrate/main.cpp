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
#include "cli/own_pages.h"
#include "cli/parse.h"
#include "cli/print.h"
#include "cli/usage_error.h"

namespace gsim::calibrate {

namespace {

constexpr const char* kName = "gsim-calibrate";

int refuse(const std::string& why) {
    apps::tell_fault(kName, why);
    return apps::usage_error(kName, fmt::format("{} --help tells what there is", kName));
}

int run(const std::vector<std::string>& words) {
    apps::CommandLine line(kName,
                           "Makes a machine file from what a machine did: from recorded runs, "
                           "measured tips, or set points and places of axes");
    Chosen chosen;
    add_times(line, chosen);
    add_geometry(line, chosen);
    add_servo(line, chosen);
    const std::vector<std::string> others{"gsim", "gsim-run", "gsim-check"};
    if (const auto printed = apps::print_own_pages(line, words, others)) return *printed;
    if (words.empty()) {
        apps::print(apps::help_text(line, &line));
        return apps::kUsage;
    }
    const auto parsed = apps::parse(line, words);
    if (!parsed) return refuse(parsed.error());
    if (*parsed) return **parsed;
    if (const auto conflict = apps::find_file_conflict(line)) return refuse(*conflict);
    if (const Done done = chosen(); !done) {
        apps::tell_fault(kName, done.error());
        return apps::kProgramFault;
    }
    return apps::kDone;
}

}  // namespace

}  // namespace gsim::calibrate

int main(int argc, char** argv) {
    try {
        return gsim::apps::finish_standard_output(
            gsim::calibrate::run(std::vector<std::string>(argv + 1, argv + argc)));
    } catch (const std::exception& error) {
        gsim::apps::tell_fault("gsim-calibrate", error.what());
        return gsim::apps::kProgramFault;
    }
}

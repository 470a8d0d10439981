#include "calibrate/command.h"

#include <utility>

#include "base/os/files.h"
#include "base/os/output_file.h"
#include "cli/print.h"
#include "cli/usage_error.h"
#include "machine/file/machine_file.h"

namespace gsim::calibrate {

apps::CommandLine& add_command(apps::CommandLine& line, SelectedCommand& selected, const char* name,
                               const char* description, SelectedCommand action) {
    apps::CommandLine& command =
        line.add_command(name, description, [&selected, action = std::move(action)] { selected = action; });
    command.begin_group("Options");
    return command;
}

Result<machine::Machine> read_machine_argument(const std::string& file) {
    machine::FileMessages messages;
    auto machine = machine::load_machine(file, os::NameSource::in_file, os::disk(), &messages);
    for (const std::string& warning : messages.warnings)
        apps::report_error("gsim-calibrate", "warning: " + warning);
    return machine;
}

Result<void> write_if_named(const std::string& file, const std::string& text) {
    if (file.empty()) return {};
    return os::write_file(file, text);
}

Result<void> write_or_print(const std::string& file, const std::string& text) {
    if (!file.empty()) return os::write_file(file, text);
    apps::print(text);
    return {};
}

}  // namespace gsim::calibrate

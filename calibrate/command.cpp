#include "calibrate/command.h"

#include <utility>

#include "base/os/output_file.h"
#include "cli/print.h"

namespace gsim::calibrate {

apps::CommandLine& add_command(apps::CommandLine& line, Chosen& chosen, const char* name,
                               const char* description, Chosen does) {
    apps::CommandLine& command =
        line.add_command(name, description, [&chosen, does = std::move(does)] { chosen = does; });
    command.begin_group("Options");
    return command;
}

Done write_if(const std::string& file, const std::string& text) {
    if (file.empty()) return {};
    return os::write_file(file, text);
}

Done write_or_print(const std::string& file, const std::string& text) {
    if (!file.empty()) return os::write_file(file, text);
    apps::print(text);
    return {};
}

}  // namespace gsim::calibrate

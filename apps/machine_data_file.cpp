#include "apps/machine_data_file.h"

#include <chrono>

#include "base/os/output_file.h"

namespace gsim::apps {

void add_wait_option(CommandLine& line, double& wait_s) {
    constexpr double kMax_s = 86'400;
    line.add("--wait", &wait_s, "max time to wait for a file that another program is changing")
        .with_value_name("SECONDS")
        .within(0, kMax_s)
        .show_default();
}

Result<os::FileLock> lock_for_change(const std::string& path, double wait_s) {
    const std::chrono::duration<double> wait(wait_s);
    return os::FileLock::get(path, std::chrono::duration_cast<std::chrono::milliseconds>(wait));
}

Result<void> save_text(const std::string& path, std::string_view text) {
    return os::write_file(path, text, os::Durability::disk);
}

Result<void> replace_text(const std::string& path, std::string_view text, double wait_s) {
    const auto lock = lock_for_change(path, wait_s);
    if (!lock) return tl::unexpected(lock.error());
    return save_text(path, text);
}

}  // namespace gsim::apps

#include "batch/work/job_edits.h"

#include <string>
#include <utility>

#include <fmt/format.h>

#include "batch/work/edits.h"
#include "batch/work/run_options.h"
#include "engine/machine.h"
#include "machine/file/machine_file.h"

namespace gsim::batch {

namespace {

constexpr const char* kBuiltInName = "built-in machine.toml";

/// Editor that replaces the files of the settings by edited texts.
class Edits {
  public:
    Edits(const Job& job, engine::Request& request, RunFiles& files)
        : job_(job), request_(request), files_(files) {}

    Result<void> make() {
        // The cell comes first, because a changed cell may name another machine.
        return cell().and_then([&] { return robots(); }).and_then([&] { return machine(); }).and_then([&] {
            return data();
        });
    }

  private:
    /// Returns the text of a file that is referenced by name.
    Result<std::string> find_and_read(engine::NameKind kind, std::string& name) {
        auto found = request_.host.find(kind, name);
        if (!found) return Unexpected(found.error());
        name = *std::move(found);
        auto text = files_.read(name);
        if (!text) return Unexpected(fmt::format("cannot read '{}'", name));
        return *std::move(text);
    }

    Result<void> machine() {
        const auto settings = settings_with_prefix(job_.settings, kMachinePrefix);
        if (settings.empty()) return {};
        if (request_.machine.empty() && !request_.cell.empty()) {
            auto cell_machine = engine::Machine::read(request_);
            if (!cell_machine) return Unexpected(cell_machine.error().message);
            request_.machine = cell_machine->machine_file();
        }
        Result<std::string> text = std::string(machine::built_in_machine_toml());
        if (request_.machine.empty()) {
            request_.machine = kBuiltInName;
        } else {
            text = find_and_read(engine::NameKind::machine, request_.machine);
        }
        if (!text) return Unexpected(text.error());
        return replace_text(request_.machine, edit_toml(*std::move(text), request_.machine, settings));
    }

    Result<void> cell() {
        const auto settings = settings_with_prefix(job_.settings, kCellPrefix);
        if (settings.empty()) return {};
        if (request_.cell.empty())
            return Unexpected("a setting of the cell requires a cell file (option 'cell')");
        auto text = find_and_read(engine::NameKind::sample, request_.cell);
        if (!text) return Unexpected(text.error());
        return replace_text(request_.cell, edit_toml(*std::move(text), request_.cell, settings));
    }

    Result<void> robots() {
        const auto settings = settings_with_prefix(job_.settings, kRobotsPrefix);
        if (settings.empty()) return {};
        if (request_.robots.empty())
            return Unexpected("a setting of robots requires a robots file (option 'robots')");
        auto text = find_and_read(engine::NameKind::sample, request_.robots);
        if (!text) return Unexpected(text.error());
        return replace_text(request_.robots, edit_toml(*std::move(text), request_.robots, settings));
    }

    Result<void> data() {
        const auto settings = settings_with_prefix(job_.settings, kDataPrefix);
        if (settings.empty()) return {};
        if (request_.machine_data.empty())
            return Unexpected(
                "a setting of machine data requires a machine data file (option 'machine_data')");
        const auto text = find_and_read(engine::NameKind::sample, request_.machine_data);
        if (!text) return Unexpected(text.error());
        return replace_text(request_.machine_data, edit_data(*text, request_.machine_data, settings));
    }

    Result<void> replace_text(const std::string& name, Result<std::string> edit_result) {
        return std::move(edit_result).map([&](std::string text) { files_.replace(name, std::move(text)); });
    }

    const Job& job_;
    engine::Request& request_;
    RunFiles& files_;
};

}  // namespace

Result<void> make_edits(const Job& job, engine::Request& request, RunFiles& files) {
    return Edits(job, request, files).make();
}

Result<void> set_options(const Job& job, JobRequest& request) {
    for (const auto& [name, value] : job.options.items()) {
        if (const auto set = set_option(request, name, value); !set) return Unexpected(set.error());
    }
    for (const SettingValue& setting : settings_with_prefix(job.settings, kOptionPrefix)) {
        if (const auto set = set_option(request, setting.key, setting.value); !set)
            return Unexpected(set.error());
    }
    return {};
}

}  // namespace gsim::batch

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

using Done = tl::expected<void, std::string>;
using Fault = tl::unexpected<std::string>;

constexpr const char* kBuiltIn = "built-in machine.toml";

/// Editor that replaces the files of the settings by edited texts.
class Edits {
  public:
    Edits(const Job& job, engine::Request& request, FilesOfRun& files)
        : job_(job), request_(request), files_(files) {}

    Done make() {
        // The cell comes first, because a changed cell may name another machine.
        return cell().and_then([&] { return robots(); }).and_then([&] { return machine(); }).and_then([&] {
            return data();
        });
    }

  private:
    /// Returns the text of a file that is referenced by name.
    tl::expected<std::string, std::string> text_of(engine::NameKind kind, std::string& name) {
        auto found = request_.host.find(kind, name);
        if (!found) return Fault(found.error());
        name = *std::move(found);
        auto text = files_.read(name);
        if (!text) return Fault(fmt::format("cannot read '{}'", name));
        return *std::move(text);
    }

    Done machine() {
        const auto settings = settings_of(job_.settings, kOfMachine);
        if (settings.empty()) return {};
        if (request_.machine.empty() && !request_.cell.empty()) {
            auto of_cell = engine::Machine::read(request_);
            if (!of_cell) return Fault(of_cell.error().message);
            request_.machine = of_cell->machine_file();
        }
        tl::expected<std::string, std::string> text = std::string(machine::built_in_machine_toml());
        if (request_.machine.empty()) {
            request_.machine = kBuiltIn;
        } else {
            text = text_of(engine::NameKind::machine, request_.machine);
        }
        if (!text) return Fault(text.error());
        return put(request_.machine, edited_toml(*std::move(text), request_.machine, settings));
    }

    Done cell() {
        const auto settings = settings_of(job_.settings, kOfCell);
        if (settings.empty()) return {};
        if (request_.cell.empty()) return Fault("a setting of the cell needs a cell file (option 'cell')");
        auto text = text_of(engine::NameKind::sample, request_.cell);
        if (!text) return Fault(text.error());
        return put(request_.cell, edited_toml(*std::move(text), request_.cell, settings));
    }

    Done robots() {
        const auto settings = settings_of(job_.settings, kOfRobots);
        if (settings.empty()) return {};
        if (request_.robots.empty())
            return Fault("a setting of robots needs a file of them (option 'robots')");
        auto text = text_of(engine::NameKind::sample, request_.robots);
        if (!text) return Fault(text.error());
        return put(request_.robots, edited_toml(*std::move(text), request_.robots, settings));
    }

    Done data() {
        const auto settings = settings_of(job_.settings, kOfData);
        if (settings.empty()) return {};
        if (request_.machine_data.empty())
            return Fault("a setting of machine data needs a file of them (option 'machine_data')");
        const auto text = text_of(engine::NameKind::sample, request_.machine_data);
        if (!text) return Fault(text.error());
        return put(request_.machine_data, edited_data(*text, request_.machine_data, settings));
    }

    Done put(const std::string& name, tl::expected<std::string, std::string> edited) {
        return std::move(edited).map([&](std::string text) { files_.replace(name, std::move(text)); });
    }

    const Job& job_;
    engine::Request& request_;
    FilesOfRun& files_;
};

}  // namespace

Done make_edits(const Job& job, engine::Request& request, FilesOfRun& files) {
    return Edits(job, request, files).make();
}

Done set_options(const Job& job, JobRequest& request) {
    for (const auto& [name, value] : job.options.items()) {
        if (const auto set = set_option(request, name, value); !set) return Fault(set.error());
    }
    for (const SettingValue& setting : settings_of(job.settings, kOfRun)) {
        if (const auto set = set_option(request, setting.key, setting.value); !set) return Fault(set.error());
    }
    return {};
}

}  // namespace gsim::batch

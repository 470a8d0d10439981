#include "apps/data_commands.h"

#include <array>
#include <filesystem>
#include <utility>

#include "apps/confine_run.h"
#include "apps/data_import.h"
#include "apps/machine_data_file.h"
#include "apps/to_error.h"
#include "base/os/input_file.h"
#include "base/text/printable.h"
#include "cli/exit_status.h"
#include "cli/print.h"
#include "engine/system/system_host.h"

namespace gsim::apps {

using engine::MachineData;

namespace {

using Status = Result<int>;

Status print_result(const tl::expected<std::string, engine::Error>& result) {
    if (!result) return Unexpected(result.error().message);
    print(text::printable(*result));
    return kSuccess;
}

class Command {
  public:
    Command(const DataArguments& arguments, const engine::Machine* machine, Findings& findings)
        : arguments_(arguments), findings_(findings), machine_(machine) {}

    Status run() {
        if (arguments_.command == DataCommand::check) return check();
        return lock()
            .and_then([this] { return is_from_json() ? from_json() : open(); })
            .and_then([this](MachineData data) { return execute(data); });
    }

  private:
    using OpenResult = Result<MachineData>;

    std::optional<engine::LengthUnit> unit() const {
        if (arguments_.inch) return engine::LengthUnit::inch;
        return arguments_.metric ? std::optional(engine::LengthUnit::mm) : std::nullopt;
    }

    MachineData::Format data_format() const {
        return arguments_.findings.json ? MachineData::Format::json : MachineData::Format::text;
    }

    bool is_from_json() const {
        return arguments_.command == DataCommand::convert && !arguments_.from_json.empty();
    }

    /// Returns true if FILE itself is changed.
    bool changes_file() const {
        switch (arguments_.command) {
            case DataCommand::set:
            case DataCommand::reset:
            case DataCommand::reset_all: return true;
            case DataCommand::convert:
                return arguments_.output.empty() && (is_from_json() || !arguments_.findings.json);
            default: return false;
        }
    }

    // Locks the file from before it is read until it is written.
    Result<void> lock() {
        if (!changes_file()) return {};
        return lock_for_change(arguments_.file, arguments_.wait_s).map([this](os::FileLock lock) {
            lock_.emplace(std::move(lock));
        });
    }

    OpenResult open() const {
        std::error_code error;
        if (arguments_.create && !std::filesystem::exists(arguments_.file, error) && !error)
            return MachineData(arguments_.file, machine_);
        return os::read_text_file(arguments_.file, os::NameSource::command_line)
            .and_then([this](const std::string& text) {
                return MachineData::read(text, arguments_.file, machine_).map_error(to_error);
            });
    }

    OpenResult from_json() const {
        return os::read_text_file(arguments_.from_json, os::NameSource::command_line)
            .and_then([this](const std::string& text) {
                return MachineData::from_json(text, arguments_.from_json, machine_).map_error(to_error);
            });
    }

    Status execute(MachineData& data) const {
        const DataArguments& a = arguments_;
        switch (a.command) {
            case DataCommand::list: return print_result(data.list(data_format(), a.section));
            case DataCommand::get: return print_result(data.get(data_format(), a.section, a.id, a.field));
            case DataCommand::set: return save(data.set(a.section, a.id, a.changes, unit()), data);
            case DataCommand::reset: return save(data.reset(a.section, a.id), data);
            case DataCommand::reset_all: return save(data.reset_all(a.section), data);
            case DataCommand::check:
            case DataCommand::convert:
            case DataCommand::import: break;
        }
        return convert(data);
    }

    Status check() const {
        return os::read_text_file(arguments_.file, os::NameSource::command_line)
            .map([this](const std::string& text) {
                const engine::DiagnosticHandler on_diagnostic = [this](const engine::Diagnostic& diagnostic) {
                    findings_.add(diagnostic);
                };
                const auto data = MachineData::read(text, arguments_.file, machine_, on_diagnostic);
                if (!data) return kProgramError;
                for (const engine::Diagnostic& warning : data->lint_warnings()) findings_.add(warning);
                return kSuccess;
            });
    }

    Status convert(MachineData& data) const {
        if (is_from_json()) return save({}, data);
        if (arguments_.findings.json) {
            if (arguments_.output.empty()) return print_result(data.list(MachineData::Format::json));
            return data.to_json().map_error(to_error).and_then(
                [this](const std::string& json) { return write_result(arguments_.output, json); });
        }
        if (!unit()) return Unexpected("convert requires --inch, --metric, --json or --from-json FILE");
        return save(data.convert(*unit()), data);
    }

    Status save(const tl::expected<void, engine::Error>& changed, const MachineData& data) const {
        if (!changed) return Unexpected(changed.error().message);
        return write_result(changes_file() ? arguments_.file : arguments_.output, data.text());
    }

    Status write_result(const std::string& path, const std::string& text) const {
        const auto done = lock_ ? save_text(path, text) : replace_text(path, text, arguments_.wait_s);
        return done.map([] { return kSuccess; });
    }

    const DataArguments& arguments_;
    Findings& findings_;
    const engine::Machine* machine_;
    std::optional<os::FileLock> lock_;
};

/// Confines the process once the machine has been read. Does nothing for LinuxCNC settings, because they name
/// files that may lie anywhere.
Result<void> confine(const DataArguments& a) {
    if (a.no_confine || (a.command == DataCommand::import && !imports_table(a))) return {};
    const bool shows =
        a.command == DataCommand::list || a.command == DataCommand::get || a.command == DataCommand::check;
    return confine_to(std::array{a.file, a.from_json, import_source(a)},
                      std::array{shows ? std::string() : a.file, a.output, a.data, a.findings.sarif});
}

/// Returns `std::nullopt` if no machine is named.
Result<std::optional<engine::Machine>> read_machine(const std::string& name) {
    if (name.empty()) return std::nullopt;
    engine::Request request;
    request.machine = name;
    request.host = engine::make_system_host();
    return engine::Machine::read(request)
        .map([](engine::Machine machine) { return std::optional(std::move(machine)); })
        .map_error(to_error);
}

}  // namespace

Status run_data_command(const DataArguments& arguments, Findings& findings) {
    const auto read = read_machine(arguments.machine);
    if (!read) return Unexpected(read.error());
    const engine::Machine* const machine = *read ? &**read : nullptr;
    if (auto confined = confine(arguments); !confined) return Unexpected(std::move(confined.error()));
    if (arguments.command == DataCommand::import) return import_settings(arguments, machine, findings);
    if (arguments.file.empty()) return Unexpected("FILE is required: the machine data (NCFILE)");
    return Command(arguments, machine, findings).run();
}

}  // namespace gsim::apps

#include "apps/data_commands.h"

#include <array>
#include <filesystem>

#include <fmt/format.h>

#include "apps/confine_run.h"
#include "apps/data_check.h"
#include "apps/data_import.h"
#include "apps/data_json.h"
#include "apps/data_table.h"
#include "apps/exit_status.h"
#include "apps/machine_data_file.h"
#include "apps/print.h"
#include "base/os/input_file.h"
#include "base/text/printable.h"
#include "engine/inner/machine_input.h"
#include "engine/system/host_of_system.h"

namespace gsim::apps {

using machine::DataRow;
using machine::DataSection;
using machine::LengthUnit;
using machine::MachineDataDocument;
using machine::SectionRules;

namespace {

using Status = tl::expected<int, std::string>;
using Sentence = tl::unexpected<std::string>;

Status printed(const std::string& text) {
    print(text::printable(text));
    return kDone;
}

Status printed(const nlohmann::ordered_json& json) {
    return printed(json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + '\n');
}

class Command {
  public:
    Command(const DataArguments& arguments, std::optional<machine::Machine> machine, Findings& findings)
        : arguments_(arguments), findings_(findings), machine_(std::move(machine)), document_(axes()) {}

    Status run() {
        if (arguments_.command == DataCommand::check) return check();
        if (is_from_json()) return lock().and_then([this] { return from_json(); });
        return lock()
            .and_then([this] { return open(); })
            .and_then([this] { return take_section(); })
            .and_then([this] { return run_on_document(); });
    }

  private:
    using Done = tl::expected<void, std::string>;

    std::span<const machine::Axis> axes() const {
        return machine_ ? std::span<const machine::Axis>(machine_->axes) : std::span<const machine::Axis>();
    }

    const SectionRules& rules() const { return document_.rules().of(*section_); }

    std::optional<LengthUnit> unit() const {
        if (arguments_.inch) return LengthUnit::inch;
        return arguments_.metric ? std::optional(LengthUnit::metric) : std::nullopt;
    }

    bool is_from_json() const {
        return arguments_.command == DataCommand::convert && !arguments_.from_json.empty();
    }

    /// Whether FILE itself is changed.
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

    // From before the file is read until it is written.
    Done lock() {
        if (!changes_file()) return {};
        return lock_to_change(arguments_.file, arguments_.wait_s).map([this](os::FileLock lock) {
            lock_.emplace(std::move(lock));
        });
    }

    Done open() {
        std::error_code error;
        if (arguments_.create && !std::filesystem::exists(arguments_.file, error) && !error) return {};
        auto document = open_machine_data(arguments_.file, axes(), os::NamedBy::command_line);
        if (!document) return Sentence(std::move(document.error().front()));
        document_ = *std::move(document);
        return {};
    }

    Done take_section() {
        if (arguments_.section.empty()) return {};
        section_ = machine::section_named(machine::upper_case(arguments_.section));
        if (section_) return {};
        std::string names;
        for (const DataSection section : machine::kDataSections)
            names += fmt::format("{}{}", names.empty() ? "" : ", ", machine::keyword(section));
        return Sentence(
            fmt::format("'{}' is no section; there are {}", machine::shown_word(arguments_.section), names));
    }

    Status run_on_document() {
        switch (arguments_.command) {
            case DataCommand::list: return list();
            case DataCommand::get: return get();
            case DataCommand::set: return set();
            case DataCommand::reset: return save(document_.reset(*section_, arguments_.id));
            case DataCommand::reset_all: return save(reset_all());
            case DataCommand::check: return check();
            case DataCommand::convert:
            case DataCommand::import: break;
        }
        return convert();
    }

    Status list() const {
        if (arguments_.findings.json) {
            nlohmann::ordered_json json = data_to_json(document_);
            if (!section_) return printed(json);
            return printed(json.value(std::string(rules().keyword), nlohmann::ordered_json::array()));
        }
        std::string text;
        for (const DataSection section : machine::kDataSections) {
            const bool wanted = section_ ? section == *section_ : !document_.rows(section).empty();
            if (!wanted) continue;
            if (!text.empty()) text += '\n';
            text += data_table(document_.rules().of(section), document_.rows(section));
        }
        return printed(text);
    }

    Status get() const {
        const auto row = document_.find(*section_, arguments_.id);
        if (!row)
            return Sentence(fmt::format("there is no {} {} in the file", rules().keyword, arguments_.id));
        const nlohmann::ordered_json json = row_to_json(rules(), *row);
        if (arguments_.field.empty())
            return arguments_.findings.json ? printed(json) : printed(data_list(rules(), *row));
        const std::string name = machine::upper_case(arguments_.field);
        const auto field = rules().find(name);
        if (!field) {
            return Sentence(
                fmt::format("{} has no '{}'", rules().keyword, machine::shown_word(arguments_.field)));
        }
        if (!arguments_.findings.json) return printed(fmt::format("{}\n", row->values[*field]));
        return printed(json.contains(name) ? json[name] : nlohmann::ordered_json());
    }

    Status set() {
        MachineDataDocument::FieldValues values;
        values.reserve(arguments_.changes.size());
        for (const std::string& change : arguments_.changes) {
            const std::size_t equals = change.find('=');
            if (equals == std::string::npos)
                return Sentence(fmt::format("'{}' is no FIELD=VALUE", machine::shown_word(change)));
            values.emplace_back(machine::upper_case(change.substr(0, equals)), change.substr(equals + 1));
        }
        return save(document_.set(*section_, arguments_.id, values, unit()));
    }

    Done reset_all() {
        if (section_) return document_.reset_all(*section_);
        for (const DataSection section : machine::kDataSections) {
            if (Done done = document_.reset_all(section); !done) return done;
        }
        return {};
    }

    Status check() const {
        return os::read_text_file(arguments_.file, os::NamedBy::command_line)
            .map([this](const std::string& text) {
                const auto document = MachineDataDocument::read(text, arguments_.file, axes());
                const std::vector<std::string> found =
                    document ? check_data(*document, arguments_.file, machine_) : document.error();
                for (const std::string& sentence : found)
                    findings_.take(text::diagnostic_of(text::DiagnosticKind::input_file, sentence));
                return document ? kDone : kProgramFault;
            });
    }

    Status convert() {
        if (arguments_.findings.json) {
            if (arguments_.output.empty()) return printed(data_to_json(document_));
            return saved(arguments_.output, data_to_json(document_).dump(2) + '\n');
        }
        if (!unit()) return Sentence("convert takes --inch, --metric, --json or --from-json FILE");
        return save(document_.convert(*unit()));
    }

    Status from_json() {
        return os::read_text_file(arguments_.from_json, os::NamedBy::command_line)
            .and_then([this](const std::string& text) {
                return data_from_json(text, arguments_.from_json, axes());
            })
            .and_then([this](const MachineDataDocument& document) {
                document_ = document;
                return save({});
            });
    }

    Status save(const Done& changed) const {
        if (!changed) return Sentence(fmt::format("{}: {}", arguments_.file, changed.error()));
        return saved(changes_file() ? arguments_.file : arguments_.output, document_.text());
    }

    Status saved(const std::string& path, const std::string& text) const {
        const Done done = lock_ ? save_text(path, text) : replace_text(path, text, arguments_.wait_s);
        return done.map([] { return kDone; });
    }

    const DataArguments& arguments_;
    Findings& findings_;
    std::optional<machine::Machine> machine_;
    MachineDataDocument document_;
    std::optional<DataSection> section_;
    std::optional<os::FileLock> lock_;
};

/// Behind the reading of the machine, and of what names files that may lie anywhere: settings of LinuxCNC.
tl::expected<void, std::string> confine(const DataArguments& a) {
    if (a.no_confine || (a.command == DataCommand::import && !imports_table(a))) return {};
    const bool shows =
        a.command == DataCommand::list || a.command == DataCommand::get || a.command == DataCommand::check;
    return confine_to(std::array{a.file, a.from_json, import_source(a)},
                      std::array{shows ? std::string() : a.file, a.output, a.data, a.findings.sarif});
}

}  // namespace

Status run_data_command(const DataArguments& arguments, Findings& findings) {
    std::optional<machine::Machine> machine;
    if (!arguments.machine.empty()) {
        auto loaded = engine::read_machine_input(engine::host_of_system(), arguments.machine,
                                                 os::NamedBy::command_line);
        if (!loaded) return Sentence(std::move(loaded.error()));
        machine = std::move(loaded->machine);
    }
    if (auto confined = confine(arguments); !confined) return Sentence(std::move(confined.error()));
    if (arguments.command == DataCommand::import) return import_settings(arguments, machine, findings);
    if (arguments.file.empty()) return Sentence("FILE is required: the machine data (NCFILE)");
    return Command(arguments, std::move(machine), findings).run();
}

}  // namespace gsim::apps

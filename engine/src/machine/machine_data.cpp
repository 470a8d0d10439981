#include "engine/machine_data.h"

#include <utility>

#include <fmt/format.h>

#include "base/os/files.h"
#include "engine/src/conversions.h"
#include "engine/src/guard_exceptions.h"
#include "engine/src/machine/data_json.h"
#include "engine/src/machine/data_linter.h"
#include "engine/src/machine/data_sections.h"
#include "engine/src/machine/data_table.h"
#include "engine/src/machine/machine_parts.h"

namespace gsim::engine {

using machine::DataSection;
using machine::MachineDataDocument;
using machine::SectionRules;
using text::DiagnosticKind;

namespace {

tl::unexpected<Error> unexpected_error(std::string message) {
    return tl::unexpected(make_error(DiagnosticKind::input_file, std::move(message)));
}

machine::LengthUnit to_machine_unit(LengthUnit unit) {
    return unit == LengthUnit::inch ? machine::LengthUnit::inch : machine::LengthUnit::metric;
}

std::string json_text(const nlohmann::ordered_json& json) {
    return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + '\n';
}

tl::expected<DataSection, Error> parse_section(const std::string& name) {
    if (const auto section = machine::find_section(machine::upper_case(name))) return *section;
    std::string names;
    for (const DataSection section : machine::kDataSections)
        names += fmt::format("{}{}", names.empty() ? "" : ", ", machine::keyword(section));
    return unexpected_error(
        fmt::format("'{}' is not a section; known sections: {}", machine::printable_word(name), names));
}

tl::expected<MachineDataDocument::FieldValues, Error> field_values(std::span<const std::string> changes) {
    MachineDataDocument::FieldValues values;
    values.reserve(changes.size());
    for (const std::string& change : changes) {
        const std::size_t equals = change.find('=');
        if (equals == std::string::npos)
            return unexpected_error(fmt::format("'{}' must be FIELD=VALUE", machine::printable_word(change)));
        values.emplace_back(machine::upper_case(change.substr(0, equals)), change.substr(equals + 1));
    }
    return values;
}

std::optional<machine::Machine> copy_machine_model(const Machine* machine) {
    return machine == nullptr ? std::nullopt : std::optional(machine->parts().input.machine);
}

std::span<const machine::Axis> axes_of(const std::optional<machine::Machine>& machine) {
    return machine ? std::span<const machine::Axis>(machine->axes) : std::span<const machine::Axis>();
}

std::string entries_json(const MachineDataDocument& document, std::optional<DataSection> section) {
    const nlohmann::ordered_json json = data_to_json(document);
    if (!section) return json_text(json);
    return json_text(json.value(std::string(machine::keyword(*section)), nlohmann::ordered_json::array()));
}

std::string entries_text(const MachineDataDocument& document, std::optional<DataSection> requested_section) {
    std::string text;
    for (const DataSection section : machine::kDataSections) {
        const bool is_requested =
            requested_section ? section == *requested_section : !document.rows(section).empty();
        if (!is_requested) continue;
        if (!text.empty()) text += '\n';
        text += data_table(document.rules().of(section), document.rows(section));
    }
    return text;
}

tl::expected<std::string, Error> field_value(const SectionRules& rules, const machine::DataRow& row,
                                             const std::string& field, MachineData::Format form) {
    const std::string name = machine::upper_case(field);
    const auto index = rules.find(name);
    if (!index)
        return unexpected_error(fmt::format("{} has no '{}'", rules.keyword, machine::printable_word(field)));
    if (form == MachineData::Format::text) return fmt::format("{}\n", row.values[*index]);
    const nlohmann::ordered_json json = row_to_json(rules, row);
    return json_text(json.contains(name) ? json[name] : nlohmann::ordered_json());
}

}  // namespace

struct MachineData::State {
    std::string name;
    std::optional<machine::Machine> machine;
    MachineDataDocument document;

    /// Returns the result of a change; an error gets the name of the file.
    tl::expected<void, Error> changed(const Result<void>& done) const {
        if (!done) return unexpected_error(fmt::format("{}: {}", name, done.error().message));
        return {};
    }
};

MachineData::MachineData(std::unique_ptr<State> state) : state_(std::move(state)) {}
MachineData::MachineData(MachineData&&) noexcept = default;
MachineData& MachineData::operator=(MachineData&&) noexcept = default;
MachineData::~MachineData() = default;

MachineData::MachineData(std::string name, const Machine* machine)
    : state_(std::make_unique<State>(
          State{std::move(name), copy_machine_model(machine), MachineDataDocument()})) {
    state_->document = MachineDataDocument(axes_of(state_->machine));
}

tl::expected<MachineData, Error> MachineData::open(const Host& host, const std::string& name,
                                                   const Machine* machine,
                                                   const DiagnosticHandler& on_diagnostic) {
    return guard_exceptions([&]() -> tl::expected<MachineData, Error> {
        const os::Files& files = host.files.impl();
        if (files.is_absent(name)) return MachineData(name, machine);
        const auto text = files.read_text(name);
        if (!text) return tl::unexpected(make_error(DiagnosticKind::file, text.error()));
        return read(*text, name, machine, on_diagnostic);
    });
}

tl::expected<MachineData, Error> MachineData::read(std::string_view text, std::string name,
                                                   const Machine* machine,
                                                   const DiagnosticHandler& on_diagnostic) {
    return guard_exceptions([&]() -> tl::expected<MachineData, Error> {
        MachineData data(std::move(name), machine);
        State& state = *data.state_;
        auto document = MachineDataDocument::read(text, state.name, axes_of(state.machine));
        if (!document) {
            for (const gsim::Error& error : document.error()) {
                if (on_diagnostic)
                    on_diagnostic(
                        to_diagnostic(text::to_diagnostic(DiagnosticKind::input_file, error.message)));
            }
            Error error = make_error(DiagnosticKind::input_file, document.error().front());
            error.in_program = true;
            return tl::unexpected(std::move(error));
        }
        state.document = *std::move(document);
        return data;
    });
}

tl::expected<MachineData, Error> MachineData::from_json(std::string_view json, std::string name,
                                                        const Machine* machine) {
    return guard_exceptions([&]() -> tl::expected<MachineData, Error> {
        MachineData data(std::move(name), machine);
        auto document = data_from_json(json, data.state_->name, axes_of(data.state_->machine));
        if (!document) return unexpected_error(document.error().message);
        data.state_->document = *std::move(document);
        return data;
    });
}

std::string MachineData::text() const {
    return state_->document.text();
}

std::vector<MachineData::Section> MachineData::sections() const {
    return data_sections(state_->document.rules());
}

tl::expected<std::string, Error> MachineData::to_json() const {
    return guard_exceptions([this]() -> tl::expected<std::string, Error> {
        try {
            return data_to_json(state_->document).dump(2) + '\n';
        } catch (const nlohmann::json::type_error&) {
            return unexpected_error(
                fmt::format("{}: JSON must be UTF-8, but a word in this file is not", state_->name));
        }
    });
}

tl::expected<std::string, Error> MachineData::list(Format form, const std::string& section) const {
    return guard_exceptions([&]() -> tl::expected<std::string, Error> {
        std::optional<DataSection> requested_section;
        if (!section.empty()) {
            const auto found = parse_section(section);
            if (!found) return tl::unexpected(found.error());
            requested_section = *found;
        }
        return form == Format::json ? entries_json(state_->document, requested_section)
                                    : entries_text(state_->document, requested_section);
    });
}

tl::expected<std::string, Error> MachineData::get(Format form, const std::string& section,
                                                  const std::string& id, const std::string& field) const {
    return guard_exceptions([&]() -> tl::expected<std::string, Error> {
        const auto found = parse_section(section);
        if (!found) return tl::unexpected(found.error());
        const SectionRules& rules = state_->document.rules().of(*found);
        const auto row = state_->document.find(*found, id);
        if (!row) return unexpected_error(fmt::format("{} {} does not exist in the file", rules.keyword, id));
        if (!field.empty()) return field_value(rules, *row, field, form);
        return form == Format::json ? json_text(row_to_json(rules, *row)) : data_list(rules, *row);
    });
}

std::vector<Diagnostic> MachineData::lint_warnings() const {
    std::vector<Diagnostic> diagnostics;
    for (const std::string& message : lint_machine_data(state_->document, state_->name, state_->machine))
        diagnostics.push_back(to_diagnostic(text::to_diagnostic(DiagnosticKind::input_file, message)));
    return diagnostics;
}

tl::expected<void, Error> MachineData::set(const std::string& section, const std::string& id,
                                           std::span<const std::string> changes,
                                           std::optional<LengthUnit> unit) {
    return guard_exceptions([&]() -> tl::expected<void, Error> {
        const auto found = parse_section(section);
        if (!found) return tl::unexpected(found.error());
        const auto values = field_values(changes);
        if (!values) return tl::unexpected(values.error());
        std::optional<machine::LengthUnit> impl;
        if (unit) impl = to_machine_unit(*unit);
        return state_->changed(state_->document.set(*found, id, *values, impl));
    });
}

tl::expected<void, Error> MachineData::reset(const std::string& section, const std::string& id) {
    return guard_exceptions([&] {
        return parse_section(section).and_then(
            [&](DataSection found) { return state_->changed(state_->document.reset(found, id)); });
    });
}

tl::expected<void, Error> MachineData::reset_all(const std::string& section) {
    return guard_exceptions([&]() -> tl::expected<void, Error> {
        if (!section.empty()) {
            return parse_section(section).and_then(
                [&](DataSection found) { return state_->changed(state_->document.reset_all(found)); });
        }
        MachineDataDocument document = state_->document;
        for (const DataSection each : machine::kDataSections) {
            if (auto done = state_->changed(document.reset_all(each)); !done) return done;
        }
        state_->document = std::move(document);
        return {};
    });
}

tl::expected<void, Error> MachineData::convert(LengthUnit unit) {
    return guard_exceptions([&] { return state_->changed(state_->document.convert(to_machine_unit(unit))); });
}

}  // namespace gsim::engine

#include "engine/machine_data.h"

#include <utility>

#include <fmt/format.h>

#include "base/os/files.h"
#include "engine/src/guarded.h"
#include "engine/src/machine/data_json.h"
#include "engine/src/machine/data_sections.h"
#include "engine/src/machine/data_suspects.h"
#include "engine/src/machine/data_table.h"
#include "engine/src/machine/machine_parts.h"
#include "engine/src/values.h"

namespace gsim::engine {

using machine::DataSection;
using machine::MachineDataDocument;
using machine::SectionRules;
using text::DiagnosticKind;

namespace {

tl::unexpected<Failure> refused(std::string sentence) {
    return tl::unexpected(failure_of(DiagnosticKind::input_file, std::move(sentence)));
}

machine::LengthUnit inner_unit(LengthUnit unit) {
    return unit == LengthUnit::inch ? machine::LengthUnit::inch : machine::LengthUnit::metric;
}

std::string json_text(const nlohmann::ordered_json& json) {
    return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + '\n';
}

tl::expected<DataSection, Failure> section_of(const std::string& name) {
    if (const auto section = machine::section_named(machine::upper_case(name))) return *section;
    std::string names;
    for (const DataSection section : machine::kDataSections)
        names += fmt::format("{}{}", names.empty() ? "" : ", ", machine::keyword(section));
    return refused(fmt::format("'{}' is no section; there are {}", machine::shown_word(name), names));
}

tl::expected<MachineDataDocument::FieldValues, Failure> field_values(std::span<const std::string> changes) {
    MachineDataDocument::FieldValues values;
    values.reserve(changes.size());
    for (const std::string& change : changes) {
        const std::size_t equals = change.find('=');
        if (equals == std::string::npos)
            return refused(fmt::format("'{}' is no FIELD=VALUE", machine::shown_word(change)));
        values.emplace_back(machine::upper_case(change.substr(0, equals)), change.substr(equals + 1));
    }
    return values;
}

std::optional<machine::Machine> inner_machine(const Machine* machine) {
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

std::string entries_text(const MachineDataDocument& document, std::optional<DataSection> asked) {
    std::string text;
    for (const DataSection section : machine::kDataSections) {
        const bool wanted = asked ? section == *asked : !document.rows(section).empty();
        if (!wanted) continue;
        if (!text.empty()) text += '\n';
        text += data_table(document.rules().of(section), document.rows(section));
    }
    return text;
}

tl::expected<std::string, Failure> value_of(const SectionRules& rules, const machine::DataRow& row,
                                            const std::string& field, MachineData::Form form) {
    const std::string name = machine::upper_case(field);
    const auto index = rules.find(name);
    if (!index) return refused(fmt::format("{} has no '{}'", rules.keyword, machine::shown_word(field)));
    if (form == MachineData::Form::text) return fmt::format("{}\n", row.values[*index]);
    const nlohmann::ordered_json json = row_to_json(rules, row);
    return json_text(json.contains(name) ? json[name] : nlohmann::ordered_json());
}

}  // namespace

struct MachineData::State {
    std::string name;
    std::optional<machine::Machine> machine;
    MachineDataDocument document;

    /// Returns the result of a change; an error gets the name of the file.
    tl::expected<void, Failure> changed(const MachineDataDocument::Changed& done) const {
        if (!done) return refused(fmt::format("{}: {}", name, done.error()));
        return {};
    }
};

MachineData::MachineData(std::unique_ptr<State> state) : state_(std::move(state)) {}
MachineData::MachineData(MachineData&&) noexcept = default;
MachineData& MachineData::operator=(MachineData&&) noexcept = default;
MachineData::~MachineData() = default;

MachineData::MachineData(std::string name, const Machine* machine)
    : state_(std::make_unique<State>(State{std::move(name), inner_machine(machine), MachineDataDocument()})) {
    state_->document = MachineDataDocument(axes_of(state_->machine));
}

tl::expected<MachineData, Failure> MachineData::open(const Host& host, const std::string& name,
                                                     const Machine* machine, const Tell& tell) {
    return guarded([&]() -> tl::expected<MachineData, Failure> {
        const os::Files& files = host.files.inner();
        if (files.is_absent(name)) return MachineData(name, machine);
        const auto text = files.read_text(name);
        if (!text) return tl::unexpected(failure_of(DiagnosticKind::file, text.error()));
        return read(*text, name, machine, tell);
    });
}

tl::expected<MachineData, Failure> MachineData::read(std::string_view text, std::string name,
                                                     const Machine* machine, const Tell& tell) {
    return guarded([&]() -> tl::expected<MachineData, Failure> {
        MachineData data(std::move(name), machine);
        State& state = *data.state_;
        auto document = MachineDataDocument::read(text, state.name, axes_of(state.machine));
        if (!document) {
            for (const std::string& sentence : document.error()) {
                if (tell) tell(diagnostic_of(text::diagnostic_of(DiagnosticKind::input_file, sentence)));
            }
            Failure failure = failure_of(DiagnosticKind::input_file, document.error().front());
            failure.in_program = true;
            return tl::unexpected(std::move(failure));
        }
        state.document = *std::move(document);
        return data;
    });
}

tl::expected<MachineData, Failure> MachineData::from_json(std::string_view json, std::string name,
                                                          const Machine* machine) {
    return guarded([&]() -> tl::expected<MachineData, Failure> {
        MachineData data(std::move(name), machine);
        auto document = data_from_json(json, data.state_->name, axes_of(data.state_->machine));
        if (!document) return refused(document.error());
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

tl::expected<std::string, Failure> MachineData::to_json() const {
    return guarded([this]() -> tl::expected<std::string, Failure> {
        try {
            return data_to_json(state_->document).dump(2) + '\n';
        } catch (const nlohmann::json::type_error&) {
            return refused(fmt::format("{}: JSON is UTF-8, and a word in this file is not", state_->name));
        }
    });
}

tl::expected<std::string, Failure> MachineData::list(Form form, const std::string& section) const {
    return guarded([&]() -> tl::expected<std::string, Failure> {
        std::optional<DataSection> asked;
        if (!section.empty()) {
            const auto found = section_of(section);
            if (!found) return tl::unexpected(found.error());
            asked = *found;
        }
        return form == Form::json ? entries_json(state_->document, asked)
                                  : entries_text(state_->document, asked);
    });
}

tl::expected<std::string, Failure> MachineData::get(Form form, const std::string& section,
                                                    const std::string& id, const std::string& field) const {
    return guarded([&]() -> tl::expected<std::string, Failure> {
        const auto found = section_of(section);
        if (!found) return tl::unexpected(found.error());
        const SectionRules& rules = state_->document.rules().of(*found);
        const auto row = state_->document.find(*found, id);
        if (!row) return refused(fmt::format("there is no {} {} in the file", rules.keyword, id));
        if (!field.empty()) return value_of(rules, *row, field, form);
        return form == Form::json ? json_text(row_to_json(rules, *row)) : data_list(rules, *row);
    });
}

std::vector<Diagnostic> MachineData::suspects() const {
    std::vector<Diagnostic> told;
    for (const std::string& sentence : data_suspects(state_->document, state_->name, state_->machine))
        told.push_back(diagnostic_of(text::diagnostic_of(DiagnosticKind::input_file, sentence)));
    return told;
}

tl::expected<void, Failure> MachineData::set(const std::string& section, const std::string& id,
                                             std::span<const std::string> changes,
                                             std::optional<LengthUnit> unit) {
    return guarded([&]() -> tl::expected<void, Failure> {
        const auto found = section_of(section);
        if (!found) return tl::unexpected(found.error());
        const auto values = field_values(changes);
        if (!values) return tl::unexpected(values.error());
        std::optional<machine::LengthUnit> inner;
        if (unit) inner = inner_unit(*unit);
        return state_->changed(state_->document.set(*found, id, *values, inner));
    });
}

tl::expected<void, Failure> MachineData::reset(const std::string& section, const std::string& id) {
    return guarded([&] {
        return section_of(section).and_then(
            [&](DataSection found) { return state_->changed(state_->document.reset(found, id)); });
    });
}

tl::expected<void, Failure> MachineData::reset_all(const std::string& section) {
    return guarded([&]() -> tl::expected<void, Failure> {
        if (!section.empty()) {
            return section_of(section).and_then(
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

tl::expected<void, Failure> MachineData::convert(LengthUnit unit) {
    return guarded([&] { return state_->changed(state_->document.convert(inner_unit(unit))); });
}

}  // namespace gsim::engine

// Shows machine data in a form: all sections with their fields, and changes of entries.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "base/text/json.h"
#include "engine/machine.h"
#include "engine/machine_data.h"
#include "studio/engine/key_reader.h"
#include "studio/engine/message.h"
#include "studio/engine/request_handlers.h"

namespace gsim::studio {

using engine::LengthUnit;
using engine::MachineData;
using nlohmann::json;

namespace {

const char* unit_of(MachineData::Quantity quantity) {
    switch (quantity) {
        case MachineData::Quantity::length: return "length";
        case MachineData::Quantity::angle: return "angle";
        case MachineData::Quantity::unknown:
        case MachineData::Quantity::number:
        case MachineData::Quantity::integer:
        case MachineData::Quantity::text: break;
    }
    return "none";
}

nlohmann::ordered_json field_json(const MachineData::Field& field) {
    nlohmann::ordered_json json{{"name", field.name},
                                {"unit", unit_of(field.quantity)},
                                {"meaning", field.meaning},
                                {"required", field.required},
                                {"open", field.may_be_unlimited}};
    if (!field.choices.empty()) json["choices"] = field.choices;
    if (field.quantity == MachineData::Quantity::integer)
        json.update({{"min", field.min}, {"max", field.max}});
    return json;
}

nlohmann::ordered_json sections_json(const MachineData& data) {
    auto sections = nlohmann::ordered_json::array();
    for (const MachineData::Section& section : data.sections()) {
        nlohmann::ordered_json json{{"name", section.name},
                                    {"title", section.title},
                                    {"id", section.ids},
                                    {"has_unit", section.has_unit}};
        json["fields"] = nlohmann::ordered_json::array();
        for (const MachineData::Field& field : section.fields) json["fields"].push_back(field_json(field));
        sections.push_back(std::move(json));
    }
    return sections;
}

constexpr std::array kUnits{"mm", "inch"};

void read_unit(KeyReader& keys, std::optional<LengthUnit>& unit) {
    std::optional<std::size_t> index;
    keys.word("unit", kUnits, index);
    if (index) unit = *index == 0 ? LengthUnit::mm : LengthUnit::inch;
}

/// Returns FIELD=VALUE for each.
std::vector<std::string> read_values(KeyReader& keys) {
    std::vector<std::string> changes;
    keys.require("values");
    const json* values = keys.object("values");
    if (values == nullptr) return changes;
    for (const auto& [field, value] : values->items()) {
        if (field.find('=') != std::string::npos)
            keys.add_error(fmt::format("'{}' is not the name of a field", field));
        else if (!value.is_string())
            keys.add_error(
                fmt::format("the value of '{}' must be a string, not {}", field, display_text(value)));
        else
            changes.push_back(fmt::format("{}={}", field, value.get<std::string>()));
    }
    return changes;
}

VoidResult set(MachineData& data, KeyReader& keys) {
    std::string section, id;
    std::optional<LengthUnit> unit;
    keys.required_text("section", section);
    keys.required_text("id", id);
    read_unit(keys, unit);
    const std::vector<std::string> values = read_values(keys);
    return finish_keys(keys).and_then([&] { return data.set(section, id, values, unit); });
}

VoidResult reset(MachineData& data, KeyReader& keys) {
    std::string section, id;
    keys.required_text("section", section);
    keys.required_text("id", id);
    return finish_keys(keys).and_then([&] { return data.reset(section, id); });
}

VoidResult reset_all(MachineData& data, KeyReader& keys) {
    std::string section;
    keys.text("section", section);
    return finish_keys(keys).and_then([&] { return data.reset_all(section); });
}

VoidResult convert(MachineData& data, KeyReader& keys) {
    std::optional<LengthUnit> unit;
    keys.require("unit");
    read_unit(keys, unit);
    return finish_keys(keys).and_then([&] { return data.convert(*unit); });
}

constexpr std::array kChangeNames{"set", "reset", "reset_all", "convert"};
constexpr std::array kChangeFunctions{set, reset, reset_all, convert};
static_assert(kChangeNames.size() == kChangeFunctions.size());

VoidResult change(MachineData& data, const json& request_json) {
    KeyReader keys(request_json, "a change of data");
    std::optional<std::size_t> op;
    keys.require("op");
    keys.word("op", kChangeNames, op);
    return op ? kChangeFunctions[*op](data, keys) : finish_keys(keys);
}

void send_data(const MachineData& data, const std::string& entries, const Post& post) {
    for (const engine::Diagnostic& warning : data.lint_warnings()) send_diagnostic(warning, post);
    Message message("data");
    message.header()["sections"] = sections_json(data);
    message.header()["entries"] = text::parse_json<nlohmann::ordered_json>(entries);
    message.add("text", data.text());
    post(message.bytes());
}

}  // namespace

VoidResult handle_data(const json& parameters, const engine::Request& request, const Post& post) {
    std::string file;
    KeyReader keys(parameters, "data");
    keys.required_text("file", file);
    const json* changes = keys.list("changes");
    if (auto read = finish_keys(keys); !read) return read;
    const auto machine = engine::Machine::read(request);
    if (!machine) return tl::unexpected(machine.error());
    auto data = MachineData::open(request.host, file, &*machine, [&](const engine::Diagnostic& reported) {
        send_diagnostic(reported, post);
    });
    if (!data) return tl::unexpected(data.error());
    for (std::size_t i = 0; changes != nullptr && i < changes->size(); ++i) {
        if (auto done = change(*data, (*changes)[i]); !done) return done;
    }
    const auto entries = data->list(MachineData::Format::json);
    if (!entries) return tl::unexpected(entries.error());
    send_data(*data, *entries, post);
    return {};
}

}  // namespace gsim::studio

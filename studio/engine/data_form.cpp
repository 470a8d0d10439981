// Shows machine data in a form: all sections with their fields, and changes of entries.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "base/text/json.h"
#include "engine/machine.h"
#include "engine/machine_data.h"
#include "studio/engine/answer.h"
#include "studio/engine/keys.h"
#include "studio/engine/message.h"

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
        case MachineData::Quantity::whole:
        case MachineData::Quantity::text: break;
    }
    return "none";
}

nlohmann::ordered_json field_json(const MachineData::Field& field) {
    nlohmann::ordered_json json{{"name", field.name},
                                {"unit", unit_of(field.quantity)},
                                {"meaning", field.meaning},
                                {"required", field.required},
                                {"open", field.may_be_open}};
    if (!field.choices.empty()) json["choices"] = field.choices;
    if (field.quantity == MachineData::Quantity::whole)
        json.update({{"least", field.least}, {"greatest", field.greatest}});
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

void take_unit(Keys& keys, std::optional<LengthUnit>& unit) {
    std::optional<std::size_t> index;
    keys.word("unit", kUnits, index);
    if (index) unit = *index == 0 ? LengthUnit::mm : LengthUnit::inch;
}

/// Returns FIELD=VALUE for each.
std::vector<std::string> take_values(Keys& keys) {
    std::vector<std::string> changes;
    keys.need("values");
    const json* values = keys.object("values");
    if (values == nullptr) return changes;
    for (const auto& [field, value] : values->items()) {
        if (field.find('=') != std::string::npos)
            keys.fault(fmt::format("'{}' is no name of a field", field));
        else if (!value.is_string())
            keys.fault(fmt::format("the value of '{}' should be a text, not {}", field, shown(value)));
        else
            changes.push_back(fmt::format("{}={}", field, value.get<std::string>()));
    }
    return changes;
}

Done set(MachineData& data, Keys& keys) {
    std::string section, id;
    std::optional<LengthUnit> unit;
    keys.needed_text("section", section);
    keys.needed_text("id", id);
    take_unit(keys, unit);
    const std::vector<std::string> values = take_values(keys);
    return end_of(keys).and_then([&] { return data.set(section, id, values, unit); });
}

Done reset(MachineData& data, Keys& keys) {
    std::string section, id;
    keys.needed_text("section", section);
    keys.needed_text("id", id);
    return end_of(keys).and_then([&] { return data.reset(section, id); });
}

Done reset_all(MachineData& data, Keys& keys) {
    std::string section;
    keys.text("section", section);
    return end_of(keys).and_then([&] { return data.reset_all(section); });
}

Done convert(MachineData& data, Keys& keys) {
    std::optional<LengthUnit> unit;
    keys.need("unit");
    take_unit(keys, unit);
    return end_of(keys).and_then([&] { return data.convert(*unit); });
}

constexpr std::array kOps{"set", "reset", "reset_all", "convert"};
constexpr std::array kChanges{set, reset, reset_all, convert};
static_assert(kOps.size() == kChanges.size());

Done change(MachineData& data, const json& asked) {
    Keys keys(asked, "a change of data");
    std::optional<std::size_t> op;
    keys.need("op");
    keys.word("op", kOps, op);
    return op ? kChanges[*op](data, keys) : end_of(keys);
}

void post_data(const MachineData& data, const std::string& entries, const Post& post) {
    for (const engine::Diagnostic& suspect : data.suspects()) post_told(suspect, post);
    Message message("data");
    message.header()["sections"] = sections_json(data);
    message.header()["entries"] = text::parse_json<nlohmann::ordered_json>(entries);
    message.add("text", data.text());
    post(message.bytes());
}

}  // namespace

Done answer_data(const json& own, const engine::Request& request, const Post& post) {
    std::string file;
    Keys keys(own, "data");
    keys.needed_text("file", file);
    const json* changes = keys.list("changes");
    if (auto read = end_of(keys); !read) return read;
    const auto machine = engine::Machine::read(request);
    if (!machine) return tl::unexpected(machine.error());
    auto data = MachineData::open(request.host, file, &*machine,
                                  [&](const engine::Diagnostic& told) { post_told(told, post); });
    if (!data) return tl::unexpected(data.error());
    for (std::size_t i = 0; changes != nullptr && i < changes->size(); ++i) {
        if (auto done = change(*data, (*changes)[i]); !done) return done;
    }
    const auto entries = data->list(MachineData::Form::json);
    if (!entries) return tl::unexpected(entries.error());
    post_data(*data, *entries, post);
    return {};
}

}  // namespace gsim::studio

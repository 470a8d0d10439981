#include "engine/file_keys.h"

#include <array>
#include <cstddef>
#include <utility>

#include <fmt/format.h>

#include "base/text/format.h"
#include "base/text/json.h"
#include "base/toml/renamed_keys.h"
#include "collision/cell/cell_schema.h"
#include "machine/schema/key_schema.h"

namespace gsim::engine {

namespace {

using machine::KeyKind;
using machine::KeySchema;
using machine::NumberRange;
using machine::TableSchema;
using nlohmann::ordered_json;

constexpr std::array kKinds{"number", "text", "switch", "list", "table"};  // in the order of KeyKind

const char* kind_name(KeyKind kind) {
    return kKinds.at(static_cast<std::size_t>(kind));
}

void add_range(ordered_json& json, const NumberRange& range) {
    json[range.exclusive_min ? "above" : "min"] = range.min;
    json[range.exclusive_max ? "below" : "max"] = range.max;
    auto others = ordered_json::array();
    if (range.allows_zero) others.push_back(0);
    if (range.allows_infinite) others.push_back("inf");
    if (range.allows_infinite && range.min < 0) others.push_back("-inf");
    if (!others.empty()) json["or"] = std::move(others);
    if (range.integer_only) json["integer"] = true;
}

/// A number that is not finite has the same form as in the response to `toml`.
ordered_json value_json(const std::string& written) {
    const auto value = text::try_parse_json<ordered_json>(written);
    return value.is_discarded() ? ordered_json(written) : value;
}

ordered_json key_json(const std::string& table_title, const KeySchema& key) {
    ordered_json json{{"name", key.name}, {"kind", kind_name(key.kind)}, {"meaning", key.meaning}};
    if (const auto old_name = base::old_key_name(table_title, key.name)) json["formerly"] = *old_name;
    const bool numbers =
        key.kind == KeyKind::number || (key.kind == KeyKind::list && key.elements == KeyKind::number);
    if (const std::string unit = machine::key_unit(key.name); numbers && !unit.empty()) json["unit"] = unit;
    if (numbers) add_range(json, key.range);
    if (key.kind == KeyKind::list) json["elements"] = kind_name(key.elements);
    if (key.count > 0) json["count"] = key.count;
    if (!key.fallback.empty()) json["default"] = value_json(key.fallback);
    if (!key.choices.empty()) json["choices"] = key.choices;
    if (key.open) json["open"] = true;
    if (key.required) json["required"] = true;
    if (key.many) json["pattern"] = "^M[0-9]{1,3}$";
    return json;
}

ordered_json table_json(const TableSchema& table) {
    ordered_json json{{"at", table.at}, {"many", table.many}, {"meaning", table.meaning}};
    if (!table.condition_key.empty()) json["where"] = {{table.condition_key, table.condition_value}};
    json["keys"] = ordered_json::array();
    const std::string title = fmt::format("[{}]", text::joined(table.at, "."));
    for (const KeySchema& key : table.keys) json["keys"].push_back(key_json(title, key));
    return json;
}

std::vector<TableSchema> file_schema(ConfigFileKind file) {
    switch (file) {
        case ConfigFileKind::machine: return machine::machine_schema();
        case ConfigFileKind::cell: return cell::cell_schema();
        case ConfigFileKind::controller: return machine::controller_schema();
    }
    return {};
}

}  // namespace

std::string file_keys_json(ConfigFileKind file) {
    auto tables = ordered_json::array();
    for (const TableSchema& table : file_schema(file)) tables.push_back(table_json(table));
    return tables.dump();
}

}  // namespace gsim::engine

#include "base/toml/toml_json.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <sstream>
#include <utility>

#include <fmt/format.h>

#include "base/text/utf8.h"
#include "base/toml/toml_bounds.h"
#include "base/toml/toml_path.h"
#include "base/toml/toml_section.h"
#include "base/toml/toml_writer.h"

namespace gsim::base {

namespace {

using nlohmann::json;
using nlohmann::ordered_json;

template <typename Date>
std::string date_text(const toml::value<Date>& value) {
    std::ostringstream text;
    text << value.get();
    return text.str();
}

json number_json(double value) {
    if (std::isfinite(value)) return value;
    return std::isnan(value) ? "nan" : value > 0 ? "inf" : "-inf";
}

json as_json(const toml::node& node) {
    switch (node.type()) {
        case toml::node_type::table: {
            json object = json::object();
            for (const auto& [key, value] : *node.as_table()) object[std::string(key.str())] = as_json(value);
            return object;
        }
        case toml::node_type::array: {
            json list = json::array();
            for (const toml::node& element : *node.as_array()) list.push_back(as_json(element));
            return list;
        }
        case toml::node_type::string: return node.as_string()->get();
        case toml::node_type::integer: return node.as_integer()->get();
        case toml::node_type::floating_point: return number_json(node.as_floating_point()->get());
        case toml::node_type::boolean: return node.as_boolean()->get();
        case toml::node_type::date: return date_text(*node.as_date());
        case toml::node_type::time: return date_text(*node.as_time());
        case toml::node_type::date_time: return date_text(*node.as_date_time());
        default: return nullptr;
    }
}

std::optional<Error> find_nested_error(const ordered_json& value, std::size_t depth) {
    if (value.is_structured()) {
        if (depth == kMaxTomlBrackets)
            return fmt::format("lists and objects are nested deeper than {}", kMaxTomlBrackets);
        for (const auto& [key, inner] : value.items()) {
            if (value.is_object() && !text::is_utf8(key)) return "a key is not UTF-8";
            if (auto error = find_nested_error(inner, depth + 1)) return error;
        }
        return std::nullopt;
    }
    if (value.is_string() && !text::is_utf8(value.get_ref<const std::string&>()))
        return "a string is not UTF-8";
    if (value.is_null()) return "TOML has no null; remove the key instead";
    if (value.is_number_float() && !std::isfinite(value.get<double>())) return "a number is not finite";
    if (value.is_binary() || value.is_discarded()) return "TOML does not support this value";
    return std::nullopt;
}

std::string number_text(const ordered_json& value, TomlNumbers numbers) {
    constexpr auto kMaxInteger = static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
    const bool too_large = value.is_number_unsigned() && value.get<std::uint64_t>() > kMaxInteger;
    if (numbers == TomlNumbers::floats || value.is_number_float() || too_large)
        return toml_number(value.get<double>());
    return value.dump();
}

template <typename Write>
std::string joined(const ordered_json& items, std::string_view open, std::string_view close,
                   const Write& write) {
    std::string text;
    for (const auto& [key, item] : items.items()) text += (text.empty() ? "" : ", ") + write(key, item);
    return fmt::format("{}{}{}", open, text, close);
}

bool has_fraction(const ordered_json& value) {
    if (!value.is_structured()) return value.is_number_float();
    return std::any_of(value.begin(), value.end(), has_fraction);
}

}  // namespace

Result<json> toml_json(std::string_view toml_text, std::string_view file_name) {
    FirstError error(file_name);
    const toml::table root = parse_toml(error, toml_text);
    if (error.text()) return tl::unexpected(*error.text());
    return as_json(root);
}

std::string toml_value(const ordered_json& value, TomlNumbers numbers) {
    if (value.is_string()) return toml_string(value.get_ref<const std::string&>());
    if (value.is_number()) return number_text(value, numbers);
    if (value.is_array()) {
        if (has_fraction(value)) numbers = TomlNumbers::floats;
        return joined(value, "[", "]", [&](const std::string&, const ordered_json& item) {
            return toml_value(item, numbers);
        });
    }
    if (value.is_object() && !value.empty()) {
        return joined(value, "{ ", " }", [&](const std::string& key, const ordered_json& item) {
            return fmt::format("{} = {}", toml_key(key), toml_value(item, numbers));
        });
    }
    return value.dump();  // true, false, {}
}

std::optional<Error> find_value_error(const ordered_json& value) {
    return find_nested_error(value, 0);
}

TomlNumberFormat number_format(std::string_view plain) {
    const std::string_view digits = plain.substr(plain.starts_with('+') || plain.starts_with('-') ? 1 : 0);
    if (digits == "inf" || digits == "nan") return TomlNumberFormat::decimal;
    const bool date = digits.find(':') != std::string_view::npos || digits.find('-', 4) == 4;
    if (digits.empty() || digits.front() < '0' || digits.front() > '9' || date)
        return TomlNumberFormat::other;
    const bool has_radix_prefix =
        digits.starts_with("0x") || digits.starts_with("0o") || digits.starts_with("0b");
    const bool integer_spelling = has_radix_prefix || digits.find_first_of(".eE") == std::string_view::npos;
    return integer_spelling ? TomlNumberFormat::integer_spelling : TomlNumberFormat::decimal;
}

bool is_nonfinite_name(std::string_view text) {
    return text == "inf" || text == "+inf" || text == "-inf" || text == "nan";
}

}  // namespace gsim::base

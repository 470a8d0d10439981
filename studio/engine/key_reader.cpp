#include "studio/engine/key_reader.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "base/text/format.h"

namespace gsim::studio {

using nlohmann::json;

std::string display_text(const json& value) {
    return value.is_number() ? value.dump() : fmt::format("of type {}", value.type_name());
}

KeyReader::KeyReader(const json& object, std::string of) : object_(object), owner_(std::move(of)) {
    if (!object_.is_object())
        add_error(fmt::format("{} must be an object, not {}", owner_, display_text(object_)));
}

void KeyReader::text(const char* key, std::string& target) {
    if (const json* value = value_of_type(key, "a string", &json::is_string))
        target = value->get<std::string>();
}

void KeyReader::required_text(const char* key, std::string& target) {
    require(key);
    text(key, target);
}

void KeyReader::word(const char* key, std::span<const char* const> words,
                     std::optional<std::size_t>& target) {
    const json* value = value_of_type(key, "a string", &json::is_string);
    if (value == nullptr) return;
    const auto found = std::find(words.begin(), words.end(), value->get<std::string>());
    if (found != words.end()) {
        target = static_cast<std::size_t>(found - words.begin());
    } else {
        add_error(fmt::format("'{}' must be one of {}, not '{}'", key, text::joined(words, ", "),
                              value->get<std::string>()));
    }
}

void KeyReader::number(const char* key, double min, double max, double& target) {
    std::optional<double> parsed_value;
    number(key, min, max, parsed_value);
    target = parsed_value.value_or(target);
}

void KeyReader::number(const char* key, double min, double max, std::optional<double>& target) {
    const json* value = value_of_type(key, "a number", &json::is_number);
    if (value == nullptr) return;
    const auto parsed_value = value->get<double>();
    if (!(parsed_value >= min && parsed_value <= max))
        return report_invalid(key, fmt::format("from {} to {}", min, max), *value);
    target = parsed_value;
}

void KeyReader::read_integer(const char* key, int min, int max, std::optional<int>& target) {
    const json* value = value_of_type(key, "an integer", &json::is_number_integer);
    if (value == nullptr) return;
    std::optional<double> parsed_value;
    number(key, min, max, parsed_value);
    if (parsed_value) target = static_cast<int>(*parsed_value);
}

void KeyReader::boolean(const char* key, bool& target) {
    if (const json* value = value_of_type(key, "true or false", &json::is_boolean))
        target = value->get<bool>();
}

void KeyReader::boolean(const char* key, std::optional<bool>& target) {
    if (const json* value = value_of_type(key, "true or false", &json::is_boolean))
        target = value->get<bool>();
}

void KeyReader::texts(const char* key, std::vector<std::string>& target) {
    const json* value = list(key);
    if (value != nullptr && check_elements(key, *value, "texts", &json::is_string))
        target = value->get<std::vector<std::string>>();
}

void KeyReader::numbers(const char* key, double min, double max, std::vector<double>& target) {
    const json* value = list(key);
    if (value == nullptr || !check_elements(key, *value, "numbers", &json::is_number)) return;
    const auto parsed_value = value->get<std::vector<double>>();
    const auto first_out_of_range = std::find_if(parsed_value.begin(), parsed_value.end(),
                                                 [&](double each) { return !(each >= min && each <= max); });
    if (first_out_of_range != parsed_value.end())
        return add_error(
            fmt::format("'{}' must be from {} to {}; one is {}", key, min, max, *first_out_of_range));
    target = parsed_value;
}

void KeyReader::point(const char* key, double min, double max, std::array<double, 3>& target) {
    std::optional<std::array<double, 3>> parsed_value;
    point(key, min, max, parsed_value);
    target = parsed_value.value_or(target);
}

void KeyReader::point(const char* key, double min, double max, std::optional<std::array<double, 3>>& target) {
    std::vector<double> parsed_value;
    if (any(key) == nullptr) return;
    numbers(key, min, max, parsed_value);
    if (error_) return;
    if (parsed_value.size() != 3)
        return add_error(fmt::format("'{}' must be three numbers, not {}", key, parsed_value.size()));
    target = {parsed_value[0], parsed_value[1], parsed_value[2]};
}

const json* KeyReader::list(const char* key) {
    return value_of_type(key, "a list", &json::is_array);
}

const json* KeyReader::object(const char* key) {
    return value_of_type(key, "an object", &json::is_object);
}

const json* KeyReader::any(const char* key) {
    known_keys_.emplace_back(key);
    if (!object_.is_object()) return nullptr;
    const auto found = object_.find(key);
    return found == object_.end() ? nullptr : &*found;
}

void KeyReader::require(const char* key) {
    if (any(key) == nullptr) add_error(fmt::format("{} needs '{}'", owner_, key));
}

void KeyReader::add_error(std::string message) {
    if (!error_) error_ = std::move(message);
}

Result<void> KeyReader::end() {
    for (const auto& [key, value] : object_.items()) {
        if (std::find(known_keys_.begin(), known_keys_.end(), key) == known_keys_.end())
            add_error(fmt::format("unknown key '{}' of {}", key, owner_));
    }
    if (error_) return tl::unexpected(*error_);
    return {};
}

const json* KeyReader::value_of_type(const char* key, const char* expected_type,
                                     bool (json::*is)() const noexcept) {
    const json* value = any(key);
    if (value == nullptr) return nullptr;
    if ((value->*is)()) return value;
    report_invalid(key, expected_type, *value);
    return nullptr;
}

bool KeyReader::check_elements(const char* key, const json& list, const char* expected_type,
                               bool (json::*is)() const noexcept) {
    const auto other =
        std::find_if(list.begin(), list.end(), [is](const json& each) { return !(each.*is)(); });
    if (other == list.end()) return true;
    add_error(fmt::format("'{}' must be {}; one is {}", key, expected_type, display_text(*other)));
    return false;
}

void KeyReader::report_invalid(const char* key, const std::string& expected_type, const json& value) {
    add_error(fmt::format("'{}' must be {}, not {}", key, expected_type, display_text(value)));
}

}  // namespace gsim::studio

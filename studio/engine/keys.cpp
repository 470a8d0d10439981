#include "studio/engine/keys.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "base/text/format.h"

namespace gsim::studio {

using nlohmann::json;

std::string shown(const json& value) {
    return value.is_number() ? value.dump() : fmt::format("of the kind {}", value.type_name());
}

Keys::Keys(const json& object, std::string of) : object_(object), of_(std::move(of)) {
    if (!object_.is_object()) fault(fmt::format("{} should be an object, not {}", of_, shown(object_)));
}

void Keys::text(const char* key, std::string& place) {
    if (const json* value = taken(key, "a text", &json::is_string)) place = value->get<std::string>();
}

void Keys::needed_text(const char* key, std::string& place) {
    need(key);
    text(key, place);
}

void Keys::word(const char* key, std::span<const char* const> words, std::optional<std::size_t>& place) {
    const json* value = taken(key, "a text", &json::is_string);
    if (value == nullptr) return;
    const auto found = std::find(words.begin(), words.end(), value->get<std::string>());
    if (found != words.end()) {
        place = static_cast<std::size_t>(found - words.begin());
    } else {
        fault(fmt::format("'{}' should be one of {}, not '{}'", key, text::joined(words, ", "),
                          value->get<std::string>()));
    }
}

void Keys::number(const char* key, double least, double most, double& place) {
    std::optional<double> given;
    number(key, least, most, given);
    place = given.value_or(place);
}

void Keys::number(const char* key, double least, double most, std::optional<double>& place) {
    const json* value = taken(key, "a number", &json::is_number);
    if (value == nullptr) return;
    const auto given = value->get<double>();
    if (!(given >= least && given <= most))
        return wrong(key, fmt::format("from {} to {}", least, most), *value);
    place = given;
}

void Keys::whole(const char* key, int least, int most, std::optional<int>& place) {
    const json* value = taken(key, "a whole number", &json::is_number_integer);
    if (value == nullptr) return;
    std::optional<double> given;
    number(key, least, most, given);
    if (given) place = static_cast<int>(*given);
}

void Keys::truth(const char* key, bool& place) {
    if (const json* value = taken(key, "true or false", &json::is_boolean)) place = value->get<bool>();
}

void Keys::truth(const char* key, std::optional<bool>& place) {
    if (const json* value = taken(key, "true or false", &json::is_boolean)) place = value->get<bool>();
}

void Keys::texts(const char* key, std::vector<std::string>& place) {
    const json* value = list(key);
    if (value != nullptr && all(key, *value, "texts", &json::is_string))
        place = value->get<std::vector<std::string>>();
}

void Keys::numbers(const char* key, double least, double most, std::vector<double>& place) {
    const json* value = list(key);
    if (value == nullptr || !all(key, *value, "numbers", &json::is_number)) return;
    const auto given = value->get<std::vector<double>>();
    const auto beyond = std::find_if(given.begin(), given.end(),
                                     [&](double each) { return !(each >= least && each <= most); });
    if (beyond != given.end())
        return fault(fmt::format("'{}' should be from {} to {}; one is {}", key, least, most, *beyond));
    place = given;
}

void Keys::point(const char* key, double least, double most, std::array<double, 3>& place) {
    std::optional<std::array<double, 3>> given;
    point(key, least, most, given);
    place = given.value_or(place);
}

void Keys::point(const char* key, double least, double most, std::optional<std::array<double, 3>>& place) {
    std::vector<double> given;
    if (any(key) == nullptr) return;
    numbers(key, least, most, given);
    if (fault_) return;
    if (given.size() != 3)
        return fault(fmt::format("'{}' should be three numbers, not {}", key, given.size()));
    place = {given[0], given[1], given[2]};
}

const json* Keys::list(const char* key) {
    return taken(key, "a list", &json::is_array);
}

const json* Keys::object(const char* key) {
    return taken(key, "an object", &json::is_object);
}

const json* Keys::any(const char* key) {
    known_.emplace_back(key);
    if (!object_.is_object()) return nullptr;
    const auto found = object_.find(key);
    return found == object_.end() ? nullptr : &*found;
}

void Keys::need(const char* key) {
    if (any(key) == nullptr) fault(fmt::format("{} needs '{}'", of_, key));
}

void Keys::fault(std::string sentence) {
    if (!fault_) fault_ = std::move(sentence);
}

tl::expected<void, std::string> Keys::end() {
    for (const auto& [key, value] : object_.items()) {
        if (std::find(known_.begin(), known_.end(), key) == known_.end())
            fault(fmt::format("there is no key '{}' of {}", key, of_));
    }
    if (fault_) return tl::unexpected(*fault_);
    return {};
}

const json* Keys::taken(const char* key, const char* wanted, bool (json::*is)() const noexcept) {
    const json* value = any(key);
    if (value == nullptr) return nullptr;
    if ((value->*is)()) return value;
    wrong(key, wanted, *value);
    return nullptr;
}

bool Keys::all(const char* key, const json& list, const char* wanted, bool (json::*is)() const noexcept) {
    const auto other =
        std::find_if(list.begin(), list.end(), [is](const json& each) { return !(each.*is)(); });
    if (other == list.end()) return true;
    fault(fmt::format("'{}' should be {}; one is {}", key, wanted, shown(*other)));
    return false;
}

void Keys::wrong(const char* key, const std::string& wanted, const json& value) {
    fault(fmt::format("'{}' should be {}, not {}", key, wanted, shown(value)));
}

}  // namespace gsim::studio

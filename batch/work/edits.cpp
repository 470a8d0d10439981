#include "batch/work/edits.h"

#include <algorithm>
#include <array>
#include <charconv>

#include "base/text/format.h"
#include "base/toml/toml_edit.h"
#include "batch/work/path_job.h"
#include "engine/machine_data.h"

namespace gsim::batch {

namespace {

using nlohmann::json;
using Fault = tl::unexpected<std::string>;

constexpr std::array kKinds{kOfMachine, kOfCell, kOfRobots, kOfData, kOfPath, kOfRun};
/// Keys that name an element of a list.
constexpr std::array kNames{"letter", "name", "on"};

std::vector<std::string> words_of(std::string_view key) {
    std::vector<std::string> words;
    while (true) {
        const std::size_t dot = key.find('.');
        words.emplace_back(key.substr(0, dot));
        if (dot == std::string_view::npos) return words;
        key.remove_prefix(dot + 1);
    }
}

std::optional<std::size_t> place_in(const std::string& word) {
    std::size_t place = 0;
    const char* end = word.data() + word.size();
    const auto read = std::from_chars(word.data(), end, place);
    if (read.ec != std::errc() || read.ptr != end) return std::nullopt;
    return place;
}

/// Finds an element of a list by its index or by its name.
std::optional<std::size_t> find_element(const json& list, const std::string& word) {
    if (const auto place = place_in(word)) return *place < list.size() ? place : std::nullopt;
    for (const char* name : kNames) {
        for (std::size_t i = 0; i < list.size(); ++i) {
            if (list[i].is_object() && list[i].value(name, json()) == word) return i;
        }
    }
    return std::nullopt;
}

struct Found {
    base::TomlPath path;
    const json* value = nullptr;  ///< Null: the key is new.
};

tl::expected<Found, std::string> find(const json& document, const std::string& key) {
    Found found{.path = {}, .value = &document};
    for (const std::string& word : words_of(key)) {
        if (found.value != nullptr && found.value->is_array()) {
            const auto place = find_element(*found.value, word);
            if (!place) return Fault(fmt::format("'{}': there is no '{}'", key, word));
            found.path.emplace_back(*place);
            found.value = &(*found.value)[*place];
            continue;
        }
        if (found.value != nullptr && !found.value->is_object())
            return Fault(fmt::format("'{}': nothing is below '{}'", key, base::shown(found.path)));
        found.path.emplace_back(word);
        if (found.value != nullptr)
            found.value = found.value->contains(word) ? &found.value->at(word) : nullptr;
    }
    return found;
}

tl::expected<json, std::string> value_of(const SettingValue& setting, const json* old) {
    if (setting.use == SettingUse::set) return setting.value;
    const auto value = setting.value.get<double>();
    if (setting.use == SettingUse::shift && old == nullptr) return value;  // what is not said is 0
    if (old == nullptr || !old->is_number())
        return Fault(fmt::format("'{}': {} needs a number in the file", setting.key,
                                 setting.use == SettingUse::factor ? "a factor" : "what is added"));
    return setting.use == SettingUse::factor ? old->get<double>() * value : old->get<double>() + value;
}

std::string written(const json& value) {
    if (value.is_number_integer()) return fmt::format("{}", value.get<std::int64_t>());
    if (value.is_number()) return fmt::format("{}", value.get<double>());
    return value.is_string() ? value.get<std::string>() : value.dump();
}

}  // namespace

std::vector<SettingValue> settings_of(std::span<const SettingValue> settings, std::string_view kind) {
    std::vector<SettingValue> found;
    for (const SettingValue& setting : settings) {
        if (!setting.key.starts_with(kind)) continue;
        found.push_back(setting);
        found.back().key.erase(0, kind.size());
    }
    return found;
}

std::string fault_of_key(const std::string& key) {
    const auto kind = std::find_if(kKinds.begin(), kKinds.end(),
                                   [&](std::string_view each) { return key.starts_with(each); });
    if (kind == kKinds.end())
        return fmt::format("'{}' should begin with '{}'", key, text::joined(kKinds, "', '"));
    const std::vector<std::string> words = words_of(std::string_view(key).substr(kind->size()));
    if (std::any_of(words.begin(), words.end(), [](const std::string& word) { return word.empty(); }))
        return fmt::format("'{}' has an empty name between its dots", key);
    if (*kind == kOfData && words.size() != 3)
        return fmt::format("'{}' should be data.SECTION.ID.FIELD, as data.OFFSET.54.X", key);
    if (*kind == kOfPath) return fault_of_path_key(key.substr(kind->size()));
    if (*kind == kOfRun && words.size() != 1) return fmt::format("'{}' is no option", key);
    return {};
}

tl::expected<std::string, std::string> edited_toml(std::string text, const std::string& file,
                                                   std::span<const SettingValue> settings) {
    auto edit = base::TomlEdit::read(std::move(text), file);
    if (!edit) return Fault(edit.error());
    for (const SettingValue& setting : settings) {
        const auto found = find(edit->value(), setting.key);
        if (!found) return Fault(fmt::format("{}: {}", file, found.error()));
        const auto value = value_of(setting, found->value);
        if (!value) return Fault(fmt::format("{}: {}", file, value.error()));
        if (const auto done = edit->set(found->path, *value); !done)
            return Fault(fmt::format("{}: {}", file, done.error()));
    }
    return edit->text();
}

tl::expected<std::string, std::string> edited_data(std::string_view text, const std::string& file,
                                                   std::span<const SettingValue> settings) {
    auto data = engine::MachineData::read(text, file);
    if (!data) return Fault(data.error().message);
    for (const SettingValue& setting : settings) {
        const std::vector<std::string> words = words_of(setting.key);
        if (setting.use != SettingUse::set)
            return Fault(
                fmt::format("'{}': machine data take values, no factors and nothing added", setting.key));
        const std::string change = words[2] + "=" + written(setting.value);
        if (const auto set = data->set(words[0], words[1], {&change, 1}); !set)
            return Fault(fmt::format("{}: {}", file, set.error().message));
    }
    return data->text();
}

}  // namespace gsim::batch

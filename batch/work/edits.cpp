#include "batch/work/edits.h"

#include <algorithm>
#include <array>
#include <charconv>

#include "base/text/format.h"
#include "base/toml/toml_editor.h"
#include "batch/work/path_job.h"
#include "engine/machine_data.h"

namespace gsim::batch {

namespace {

using nlohmann::json;

constexpr std::array kPrefixes{kMachinePrefix, kCellPrefix, kRobotsPrefix,
                               kDataPrefix,    kPathPrefix, kOptionPrefix};
/// Keys that name an element of a list.
constexpr std::array kNameKeys{"letter", "name", "on"};

std::vector<std::string> split_key(std::string_view key) {
    std::vector<std::string> words;
    while (true) {
        const std::size_t dot = key.find('.');
        words.emplace_back(key.substr(0, dot));
        if (dot == std::string_view::npos) return words;
        key.remove_prefix(dot + 1);
    }
}

std::optional<std::size_t> parse_index(const std::string& word) {
    std::size_t index = 0;
    const char* end = word.data() + word.size();
    const auto read = std::from_chars(word.data(), end, index);
    if (read.ec != std::errc() || read.ptr != end) return std::nullopt;
    return index;
}

/// Finds an element of a list by its index or by its name.
std::optional<std::size_t> find_element(const json& list, const std::string& word) {
    if (const auto index = parse_index(word)) return *index < list.size() ? index : std::nullopt;
    for (const char* name : kNameKeys) {
        for (std::size_t i = 0; i < list.size(); ++i) {
            if (list[i].is_object() && list[i].value(name, json()) == word) return i;
        }
    }
    return std::nullopt;
}

struct KeyMatch {
    base::TomlPath path;
    const json* value = nullptr;  ///< Null: the key is new.
};

Result<KeyMatch> find(const json& document, const std::string& key) {
    KeyMatch found{.path = {}, .value = &document};
    for (const std::string& word : split_key(key)) {
        if (found.value != nullptr && found.value->is_array()) {
            const auto index = find_element(*found.value, word);
            if (!index) return Unexpected(fmt::format("'{}': '{}' does not exist", key, word));
            found.path.emplace_back(*index);
            found.value = &(*found.value)[*index];
            continue;
        }
        if (found.value != nullptr && !found.value->is_object())
            return Unexpected(
                fmt::format("'{}': '{}' is a value without keys", key, base::display_text(found.path)));
        found.path.emplace_back(word);
        if (found.value != nullptr)
            found.value = found.value->contains(word) ? &found.value->at(word) : nullptr;
    }
    return found;
}

Result<json> edited_value(const SettingValue& setting, const json* old) {
    if (setting.use == SettingUse::set) return setting.value;
    const auto value = setting.value.get<double>();
    if (setting.use == SettingUse::shift && old == nullptr) return value;  // what is not said is 0
    if (old == nullptr || !old->is_number())
        return Unexpected(fmt::format("'{}': {} requires a number in the file", setting.key,
                                      setting.use == SettingUse::factor ? "a factor" : "an added value"));
    return setting.use == SettingUse::factor ? old->get<double>() * value : old->get<double>() + value;
}

std::string print_value(const json& value) {
    if (value.is_number_integer()) return fmt::format("{}", value.get<std::int64_t>());
    if (value.is_number()) return fmt::format("{}", value.get<double>());
    return value.is_string() ? value.get<std::string>() : value.dump();
}

}  // namespace

std::vector<SettingValue> settings_with_prefix(std::span<const SettingValue> settings,
                                               std::string_view prefix) {
    std::vector<SettingValue> found;
    for (const SettingValue& setting : settings) {
        if (!setting.key.starts_with(prefix)) continue;
        found.push_back(setting);
        found.back().key.erase(0, prefix.size());
    }
    return found;
}

std::optional<Error> find_key_name_error(const std::string& key) {
    const auto prefix = std::find_if(kPrefixes.begin(), kPrefixes.end(),
                                     [&](std::string_view each) { return key.starts_with(each); });
    if (prefix == kPrefixes.end())
        return fmt::format("'{}' must begin with '{}'", key, text::joined(kPrefixes, "', '"));
    const std::vector<std::string> words = split_key(std::string_view(key).substr(prefix->size()));
    if (std::any_of(words.begin(), words.end(), [](const std::string& word) { return word.empty(); }))
        return fmt::format("'{}' has an empty name between its dots", key);
    if (*prefix == kDataPrefix && words.size() != 3)
        return fmt::format("'{}' must be data.SECTION.ID.FIELD, such as data.OFFSET.54.X", key);
    if (*prefix == kPathPrefix) return find_path_key_error(key.substr(prefix->size()));
    if (*prefix == kOptionPrefix && words.size() != 1) return fmt::format("'{}' is not an option", key);
    return {};
}

Result<std::string> edit_toml(std::string text, const std::string& file,
                              std::span<const SettingValue> settings) {
    auto edit = base::TomlEditor::read(std::move(text), file);
    if (!edit) return Unexpected(edit.error());
    for (const SettingValue& setting : settings) {
        const auto found = find(edit->value(), setting.key);
        if (!found) return Unexpected(fmt::format("{}: {}", file, found.error().message));
        const auto value = edited_value(setting, found->value);
        if (!value) return Unexpected(fmt::format("{}: {}", file, value.error().message));
        if (const auto done = edit->set(found->path, *value); !done)
            return Unexpected(fmt::format("{}: {}", file, done.error().message));
    }
    return edit->text();
}

Result<std::string> edit_data(std::string_view text, const std::string& file,
                              std::span<const SettingValue> settings) {
    auto data = engine::MachineData::read(text, file);
    if (!data) return Unexpected(data.error().message);
    for (const SettingValue& setting : settings) {
        const std::vector<std::string> words = split_key(setting.key);
        if (setting.use != SettingUse::set)
            return Unexpected(fmt::format(
                "'{}': machine data support only values, no factors and no added values", setting.key));
        const std::string change = words[2] + "=" + print_value(setting.value);
        if (const auto set = data->set(words[0], words[1], {&change, 1}); !set)
            return Unexpected(fmt::format("{}: {}", file, set.error().message));
    }
    return data->text();
}

}  // namespace gsim::batch

#include "engine/toml_edit.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/os/files.h"
#include "base/text/json.h"
#include "base/toml/toml_edit.h"
#include "engine/src/guarded.h"
#include "engine/src/machine/key_order.h"
#include "engine/src/values.h"

namespace gsim::engine {

namespace {

using base::TomlEdit;
using base::TomlPath;
using nlohmann::ordered_json;
using text::DiagnosticKind;
using Edited = tl::expected<void, std::string>;

/// An operation, and the key that it needs in addition to "at".
struct Operation {
    std::string_view name;
    std::string_view key;  ///< Empty: none.
    Edited (*run)(TomlEdit&, const TomlPath&, const ordered_json& value);
};

/// Returns the value in an order for people; unchanged if it is invalid.
ordered_json for_people(const TomlPath& path, const ordered_json& value) {
    if (base::find_value_fault(value)) return value;
    std::vector<std::string> keys;
    for (const base::TomlStep& step : path) {
        if (const auto* key = std::get_if<std::string>(&step)) keys.push_back(*key);
    }
    return in_key_order(value, keys);
}

Edited set(TomlEdit& edit, const TomlPath& path, const ordered_json& value) {
    return edit.set(path, for_people(path, value));
}
Edited add(TomlEdit& edit, const TomlPath& path, const ordered_json& value) {
    return edit.add(path, for_people(path, value));
}
Edited remove(TomlEdit& edit, const TomlPath& path, const ordered_json& /*none*/) {
    return edit.remove(path);
}
Edited move(TomlEdit& edit, const TomlPath& path, const ordered_json& to) {
    if (!to.is_number_unsigned())
        return tl::unexpected(std::string("'to' should be the number of a place, from 0 on"));
    return edit.move(path, to.get<std::size_t>());
}

constexpr std::array kOperations{Operation{"set", "value", set}, Operation{"add", "value", add},
                                 Operation{"remove", "", remove}, Operation{"move", "to", move}};

tl::expected<TomlPath, std::string> path_of(const ordered_json& at) {
    const auto fault = [] {
        return tl::unexpected(
            std::string("'at' should be a list of keys and of numbers of elements, from 0 on"));
    };
    if (!at.is_array()) return fault();
    TomlPath path;
    for (const ordered_json& step : at) {
        if (step.is_string()) {
            path.emplace_back(step.get<std::string>());
        } else if (step.is_number_unsigned()) {
            path.emplace_back(step.get<std::size_t>());
        } else {
            return fault();
        }
    }
    return path;
}

Edited change(TomlEdit& edit, const ordered_json& asked) {
    if (!asked.is_object()) return tl::unexpected(std::string("a change should be an object"));
    const ordered_json name = asked.value("op", ordered_json());
    const auto* const operation =
        std::find_if(kOperations.begin(), kOperations.end(),
                     [&](const Operation& each) { return name.is_string() && name == each.name; });
    if (operation == kOperations.end())
        return tl::unexpected(std::string("'op' should be one of set, add, remove, move"));
    for (const auto& [key, value] : asked.items()) {
        if (key != "op" && key != "at" && key != operation->key)
            return tl::unexpected(fmt::format("there is no key '{}' of '{}'", key, operation->name));
    }
    const auto path = path_of(asked.value("at", ordered_json()));
    if (!path) return tl::unexpected(path.error());
    const auto value = asked.find(std::string(operation->key));
    if (!operation->key.empty() && value == asked.end())
        return tl::unexpected(fmt::format("'{}' lacks the key '{}'", operation->name, operation->key));
    return operation->run(edit, *path, value == asked.end() ? ordered_json() : *value);
}

tl::expected<TomlEdit, Failure> read(const Host& host, const std::string& name, const Tell& tell) {
    const os::Files& files = host.files.inner();
    std::string text;
    if (!files.is_absent(name)) {
        auto read = files.read_text(name);
        if (!read) return tl::unexpected(failure_of(DiagnosticKind::file, read.error()));
        text = *std::move(read);
    }
    auto edit = TomlEdit::read(std::move(text), name);
    if (edit) return *std::move(edit);
    if (tell) tell(diagnostic_of(text::diagnostic_of(DiagnosticKind::input_file, edit.error())));
    return tl::unexpected(failure_of(DiagnosticKind::input_file, edit.error(), name));
}

}  // namespace

tl::expected<EditedToml, Failure> edited_toml(const Host& host, const std::string& name,
                                              std::string_view changes, const Tell& tell) {
    return guarded([&]() -> tl::expected<EditedToml, Failure> {
        const auto asked = text::try_parse_json<ordered_json>(changes);
        if (!asked.is_array())
            return tl::unexpected(failure_of(DiagnosticKind::usage, "the changes should be a list"));
        auto edit = read(host, name, tell);
        if (!edit) return tl::unexpected(edit.error());
        for (std::size_t i = 0; i < asked.size(); ++i) {
            const auto done = change(*edit, asked[i]);
            if (done) continue;
            const std::string which = asked.size() > 1 ? fmt::format("change {}: ", i + 1) : std::string();
            return tl::unexpected(failure_of(DiagnosticKind::usage, which + done.error(), name));
        }
        return EditedToml{edit->text(), edit->value().dump()};
    });
}

}  // namespace gsim::engine

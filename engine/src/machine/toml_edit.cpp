#include "engine/toml_edit.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/os/files.h"
#include "base/text/json.h"
#include "base/toml/toml_editor.h"
#include "engine/src/conversions.h"
#include "engine/src/guard_exceptions.h"
#include "engine/src/machine/key_order.h"

namespace gsim::engine {

namespace {

using base::TomlEditor;
using base::TomlPath;
using nlohmann::ordered_json;
using text::DiagnosticKind;

/// An operation, and the key that it needs in addition to "at".
struct Operation {
    std::string_view name;
    std::string_view key;  ///< Empty: none.
    Result<void> (*run)(TomlEditor&, const TomlPath&, const ordered_json& value);
};

/// Returns the value in an order for people; unchanged if it is invalid.
ordered_json in_schema_order(const TomlPath& path, const ordered_json& value) {
    if (base::find_value_error(value)) return value;
    std::vector<std::string> keys;
    for (const base::TomlStep& step : path) {
        if (const auto* key = std::get_if<std::string>(&step)) keys.push_back(*key);
    }
    return sort_keys(value, keys);
}

Result<void> set(TomlEditor& edit, const TomlPath& path, const ordered_json& value) {
    return edit.set(path, in_schema_order(path, value));
}
Result<void> add(TomlEditor& edit, const TomlPath& path, const ordered_json& value) {
    return edit.add(path, in_schema_order(path, value));
}
Result<void> remove(TomlEditor& edit, const TomlPath& path, const ordered_json& /*none*/) {
    return edit.remove(path);
}
Result<void> move(TomlEditor& edit, const TomlPath& path, const ordered_json& to) {
    if (!to.is_number_unsigned()) return Unexpected("'to' must be an index, from 0 on");
    return edit.move(path, to.get<std::size_t>());
}

constexpr std::array kOperations{Operation{"set", "value", set}, Operation{"add", "value", add},
                                 Operation{"remove", "", remove}, Operation{"move", "to", move}};

Result<TomlPath> toml_path(const ordered_json& at) {
    const auto error = [] { return Unexpected("'at' must be a list of keys and of indices, from 0 on"); };
    if (!at.is_array()) return error();
    TomlPath path;
    for (const ordered_json& step : at) {
        if (step.is_string()) {
            path.emplace_back(step.get<std::string>());
        } else if (step.is_number_unsigned()) {
            path.emplace_back(step.get<std::size_t>());
        } else {
            return error();
        }
    }
    return path;
}

Result<void> change(TomlEditor& edit, const ordered_json& operation_json) {
    if (!operation_json.is_object()) return Unexpected("a change must be an object");
    const ordered_json name = operation_json.value("op", ordered_json());
    const auto* const operation =
        std::find_if(kOperations.begin(), kOperations.end(),
                     [&](const Operation& each) { return name.is_string() && name == each.name; });
    if (operation == kOperations.end()) return Unexpected("'op' must be one of set, add, remove, move");
    for (const auto& [key, value] : operation_json.items()) {
        if (key != "op" && key != "at" && key != operation->key)
            return Unexpected(fmt::format("unknown key '{}' of '{}'", key, operation->name));
    }
    const auto path = toml_path(operation_json.value("at", ordered_json()));
    if (!path) return tl::unexpected(path.error());
    const auto value = operation_json.find(std::string(operation->key));
    if (!operation->key.empty() && value == operation_json.end())
        return Unexpected(fmt::format("'{}' lacks the key '{}'", operation->name, operation->key));
    return operation->run(edit, *path, value == operation_json.end() ? ordered_json() : *value);
}

tl::expected<TomlEditor, Error> read(const Host& host, const std::string& name,
                                     const DiagnosticHandler& on_diagnostic) {
    const os::Files& files = host.files.impl();
    std::string text;
    if (!files.is_absent(name)) {
        auto read = files.read_text(name);
        if (!read) return tl::unexpected(make_error(DiagnosticKind::file, read.error()));
        text = *std::move(read);
    }
    auto edit = TomlEditor::read(std::move(text), name);
    if (edit) return *std::move(edit);
    if (on_diagnostic)
        on_diagnostic(to_diagnostic(text::to_diagnostic(DiagnosticKind::input_file, edit.error().message)));
    return tl::unexpected(make_error(DiagnosticKind::input_file, edit.error(), name));
}

}  // namespace

tl::expected<EditedToml, Error> edited_toml(const Host& host, const std::string& name,
                                            std::string_view changes,
                                            const DiagnosticHandler& on_diagnostic) {
    return guard_exceptions([&]() -> tl::expected<EditedToml, Error> {
        const auto operation_json = text::try_parse_json<ordered_json>(changes);
        if (!operation_json.is_array())
            return tl::unexpected(make_error(DiagnosticKind::usage, "the changes must be a list"));
        auto edit = read(host, name, on_diagnostic);
        if (!edit) return tl::unexpected(edit.error());
        for (std::size_t i = 0; i < operation_json.size(); ++i) {
            const auto done = change(*edit, operation_json[i]);
            if (done) continue;
            const std::string change_prefix =
                operation_json.size() > 1 ? fmt::format("change {}: ", i + 1) : std::string();
            return tl::unexpected(
                make_error(DiagnosticKind::usage, change_prefix + done.error().message, name));
        }
        return EditedToml{edit->text(), edit->value().dump()};
    });
}

}  // namespace gsim::engine

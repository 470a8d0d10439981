#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/text/json.h"
#include "base/toml/toml_editor.h"
#include "tests/fuzz/checks.h"
#include "tests/fuzz/promises.h"

namespace gsim::fuzz {
namespace {

using base::below;
using base::TomlEditor;
using base::TomlPath;
using nlohmann::json;

constexpr int kMostEdits = 30;  // each reads the document three times

/// All values of a document but the document itself.
void collect(const json& value, const TomlPath& path, std::vector<TomlPath>& paths) {
    if (!path.empty()) paths.push_back(path);
    if (!value.is_structured()) return;
    std::size_t index = 0;
    for (const auto& [key, inner] : value.items())
        collect(inner, value.is_array() ? below(path, index++) : below(path, key), paths);
}

/// Returns the result of an edit given by two bytes: position and change.
Result<void> edited(TomlEditor& edit, unsigned char where, unsigned char what) {
    static const std::vector<json> kValues{0.5,
                                           -3,
                                           true,
                                           "x # \xC3\xA4\n",
                                           json::array({1, 2.5}),
                                           {{"a b", 1}, {"c", {{"d", "e"}}}},
                                           json::array(),
                                           json::array({{{"f", 1}}, json::object()})};
    std::vector<TomlPath> paths;
    collect(edit.value(), {}, paths);
    const TomlPath path = paths.empty() ? TomlPath{"new"} : paths[where % paths.size()];
    const json& value = kValues[what / 8 % kValues.size()];
    switch (what % 8) {
        case 0:
        case 1: return edit.set(path, value);
        case 2: return edit.set(below(path, "new.key"), value);
        case 3: return edit.set(below(below(path, "a"), "b"), value);
        case 4: return edit.add(path, value);
        case 5: return edit.add(below(path, "entries"), value);
        case 6: return edit.remove(path);
        default: return edit.move(path, what / 8);
    }
}

}  // namespace

Outcome check_toml_edit(std::string_view bytes) {
    constexpr std::string_view kEnd = "\n%\n";  // no line of TOML; edits follow it
    const std::size_t end = bytes.find(kEnd);
    const std::string_view text = bytes.substr(0, end);
    auto edit = TomlEditor::read(std::string(text), "fuzz.toml");
    if (!edit) return refused_with(edit.error().message, "fuzz.toml");
    std::string_view edits =
        end == std::string_view::npos ? std::string_view() : bytes.substr(end + kEnd.size());
    for (int i = 0; i < kMostEdits && edits.size() >= 2; ++i, edits.remove_prefix(2)) {
        const std::string before = edit->text();
        const json value_before = edit->value();
        const auto done =
            edited(*edit, static_cast<unsigned char>(edits[0]), static_cast<unsigned char>(edits[1]));
        if (!done) {
            if (auto violation = fault_of_sentence(done.error().message))
                return broken(*std::move(violation));
            if (edit->text() != before || edit->value() != value_before)
                return broken("a change that is refused has changed something");
            continue;
        }
        const auto repeated = base::toml_json(edit->text(), "again");
        if (!repeated)
            return broken(
                fmt::format("what is written is no TOML: {}\n{}", repeated.error().message, edit->text()));
        if (*repeated != edit->value())
            return broken(fmt::format("what is written is another value:\n{}", edit->text()));
    }
    return accepted();
}

}  // namespace gsim::fuzz

#include "base/toml/toml_path.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "base/toml/toml_writer.h"

namespace gsim::base {

namespace {

bool is_bare(char c) {
    return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
}

}  // namespace

std::string display_text(const TomlPath& path) {
    std::string text;
    for (const TomlStep& step : path) {
        if (const auto* index = std::get_if<std::size_t>(&step)) {
            text += fmt::format("[{}]", *index);
        } else {
            text += text.empty() ? "" : ".";
            text += toml_key(std::get<std::string>(step));
        }
    }
    return text;
}

bool has_prefix(const TomlPath& path, const TomlPath& to) {
    return path.size() >= to.size() && std::equal(to.begin(), to.end(), path.begin());
}

TomlPath below(TomlPath path, TomlStep step) {
    path.push_back(std::move(step));
    return path;
}

std::string toml_key(std::string_view key) {
    if (!key.empty() && std::all_of(key.begin(), key.end(), is_bare)) return std::string(key);
    return toml_string(key);
}

std::string toml_keys(const TomlPath& path, std::size_t first) {
    std::string text;
    for (std::size_t i = first; i < path.size(); ++i) {
        const auto* key = std::get_if<std::string>(&path[i]);
        if (key == nullptr) continue;  // tables are named without the numbers of those around them
        text += text.empty() ? "" : ".";
        text += toml_key(*key);
    }
    return text;
}

}  // namespace gsim::base

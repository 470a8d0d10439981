#include "toolpath/json/path_names.h"

#include <variant>

#include <fmt/format.h>

namespace gsim::path {

namespace {

Error unknown_path(std::string_view name, const SourceLocation& location) {
    return {fmt::format("no path has the name '{}'", name), location.line, location.column};
}

}  // namespace

std::optional<std::size_t> PathNames::find(std::string_view name) const {
    const auto found = by_name_.find(name);
    if (found == by_name_.end()) return std::nullopt;
    return found->second;
}

std::optional<Error> PathNames::resolve(PathFile& file) const {
    if (root_) {
        const auto index = find(root_->name);
        if (!index) return unknown_path(root_->name, root_->location);
        file.program.root = *index;
    }
    for (const Use& use : uses_) {
        const auto [path, target] = use.target;
        const auto index = find(use.path_name);
        if (!index) return unknown_path(use.path_name, file.targets[path][*target]);
        std::get<SubPath>(file.program.paths[path].targets[*target]).path = *index;
    }
    return std::nullopt;
}

}  // namespace gsim::path

#include "toolpath/json/path_names.h"

#include <variant>

#include <fmt/format.h>

namespace gsim::path {

namespace {

std::string unknown_path(std::string_view name) {
    return fmt::format("there is no path of the name '{}'", name);
}

}  // namespace

std::optional<std::size_t> PathNames::find(std::string_view name) const {
    const auto found = by_name_.find(name);
    if (found == by_name_.end()) return std::nullopt;
    return found->second;
}

std::optional<PathNames::Error> PathNames::resolve(PathFile& file) const {
    if (root_) {
        const auto index = find(root_->name);
        if (!index) return Error{root_->location, unknown_path(root_->name)};
        file.program.root = *index;
    }
    for (const Use& use : uses_) {
        const auto [path, target] = use.target;
        const auto index = find(use.path_name);
        if (!index) return Error{file.targets[path][*target], unknown_path(use.path_name)};
        std::get<SubPath>(file.program.paths[path].targets[*target]).path = *index;
    }
    return std::nullopt;
}

}  // namespace gsim::path

#include "runtime/simulator/program/source_files.h"

#include <algorithm>

#include <fmt/format.h>

namespace gsim::simulation {

std::uint32_t SourceFiles::add(const std::string& name) {
    const auto index =
        static_cast<std::uint32_t>(std::find(names_.begin(), names_.end(), name) - names_.begin());
    if (index == names_.size()) names_.push_back(name);
    return index;
}

std::string SourceFiles::prefix(const SourceLocation& location) const {
    if (location.file >= names_.size() || location.line == 0) return {};
    return fmt::format("{}:{}: ", names_[location.file], location.line);
}

}  // namespace gsim::simulation

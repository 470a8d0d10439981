#include "toolpath/model/source_location.h"

#include <fmt/format.h>

namespace gsim::path {

std::string PathFile::with_location(const TargetId& id, const std::string& message) const {
    SourceLocation location;
    if (id.path < paths.size()) location = paths[id.path];
    if (id.target && id.path < targets.size() && *id.target < targets[id.path].size()) {
        location = targets[id.path][*id.target];
    }
    if (location.column == 0) return fmt::format("{}:{}: {}", file_name, location.line, message);
    return fmt::format("{}:{}:{}: {}", file_name, location.line, location.column, message);
}

}  // namespace gsim::path

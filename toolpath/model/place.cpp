#include "toolpath/model/place.h"

#include <fmt/format.h>

namespace gsim::path {

std::string PathFile::located(const TargetId& id, const std::string& sentence) const {
    Place place;
    if (id.path < paths.size()) place = paths[id.path];
    if (id.target && id.path < targets.size() && *id.target < targets[id.path].size()) {
        place = targets[id.path][*id.target];
    }
    if (place.column == 0) return fmt::format("{}:{}: {}", file_name, place.line, sentence);
    return fmt::format("{}:{}:{}: {}", file_name, place.line, place.column, sentence);
}

}  // namespace gsim::path

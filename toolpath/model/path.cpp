#include "toolpath/model/path.h"

#include <fmt/format.h>

namespace gsim::path {

std::string frame_name(std::string_view text) {
    const bool has_code =
        text.size() > 1 && (text[0] == 'G' || text[0] == 'g') && text[1] >= '0' && text[1] <= '9';
    return std::string(text.substr(has_code ? 1 : 0));
}

std::string title_of(const MachinePoint& point) {
    const char* const kind = point.kind == MachinePoint::Kind::fixed ? "fixed" : "reference";
    return point.called.empty() ? fmt::format("the {} point {}", kind, point.number)
                                : fmt::format("the {} point '{}'", kind, point.called);
}

const std::vector<std::string>& actions_of(const Target& target) {
    static const std::vector<std::string> kNone;
    if (const auto* point = std::get_if<Point>(&target)) return point->actions;
    const auto* place = std::get_if<MachinePoint>(&target);
    return place != nullptr ? place->actions : kNone;
}

const WorkFrame& frame_of(const Program& program, const SubPath& use) {
    return use.frame.name.empty() ? program.paths[use.path].frame : use.frame;
}

}  // namespace gsim::path

#include "toolpath/model/path.h"

#include <fmt/format.h>

namespace gsim::path {

std::string frame_name(std::string_view text) {
    const bool has_code =
        text.size() > 1 && (text[0] == 'G' || text[0] == 'g') && text[1] >= '0' && text[1] <= '9';
    return std::string(text.substr(has_code ? 1 : 0));
}

std::string point_title(const MachinePoint& point) {
    const char* const kind = point.kind == MachinePoint::Kind::fixed ? "fixed" : "reference";
    return point.alias.empty() ? fmt::format("the {} point {}", kind, point.number)
                               : fmt::format("the {} point '{}'", kind, point.alias);
}

const std::vector<std::string>& target_actions(const Target& target) {
    static const std::vector<std::string> kNoActions;
    if (const auto* point = std::get_if<Point>(&target)) return point->actions;
    const auto* machine_point = std::get_if<MachinePoint>(&target);
    return machine_point != nullptr ? machine_point->actions : kNoActions;
}

const WorkFrame& sub_path_frame(const Program& program, const SubPath& sub_path_call) {
    return sub_path_call.frame.name.empty() ? program.paths[sub_path_call.path].frame : sub_path_call.frame;
}

}  // namespace gsim::path

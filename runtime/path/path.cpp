#include "runtime/path/path.h"

namespace gsim::path {

std::string frame_name(std::string_view text) {
    const bool has_code =
        text.size() > 1 && (text[0] == 'G' || text[0] == 'g') && text[1] >= '0' && text[1] <= '9';
    return std::string(text.substr(has_code ? 1 : 0));
}

const WorkFrame& frame_of(const Program& program, const SubPath& use) {
    return use.frame.name.empty() ? program.paths[use.path].frame : use.frame;
}

}  // namespace gsim::path

#include "codegen/post/modal_words.h"

#include <array>
#include <cstddef>
#include <string_view>

namespace gsim::codegen {

namespace {

constexpr std::array<std::string_view, 4> kMotions = {"G00", "G01", "G02", "G03"};
constexpr std::array<std::string_view, 3> kPlanes = {"G17", "G18", "G19"};

}  // namespace

void ModalWords::write_motion(ProgramText& block, MotionWord motion) {
    const int index = static_cast<int>(motion);
    if (index == motion_ && !verbose_) return;
    motion_ = index;
    block.code(kMotions[static_cast<std::size_t>(index)]);
}

void ModalWords::write_plane(ProgramText& block, Plane plane) {
    const int index = static_cast<int>(plane);
    if (index == plane_ && !verbose_) return;
    plane_ = index;
    block.code(kPlanes[static_cast<std::size_t>(index)]);
}

}  // namespace gsim::codegen

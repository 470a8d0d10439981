#include "runtime/simulator/program/work_offsets.h"

#include <algorithm>

namespace gsim::simulation {

void WorkOffsets::select(const WorkOffset& offset) {
    selected_ = offset;
    notifier_.notify([&](ProgramObserver& observer) { observer.work_offset(offset); });
    const std::string code = "G" + offset.name;
    const auto found = std::find(codes_.begin(), codes_.end(), code);
    index_ = static_cast<std::uint16_t>(found - codes_.begin());
    if (found == codes_.end()) codes_.push_back(code);
}

}  // namespace gsim::simulation

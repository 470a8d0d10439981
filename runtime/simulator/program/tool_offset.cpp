#include "runtime/simulator/program/tool_offset.h"

namespace gsim::simulation {

tl::expected<TcpFrame, std::string> ToolOffset::make_tcp_frame(const Eigen::Vector3d& offset_mm) const {
    const AxisVector zero = AxisVector::Zero(static_cast<Eigen::Index>(motion_.setup().joint_count()));
    return TcpFrame::make(motion_.setup(), position_.to_joints(zero), frames_.tool_shift().translation(),
                          offset_mm);
}

void ToolOffset::update_tcp() {
    const auto frame = make_tcp_frame(offset_mm_);
    const Eigen::Vector3d tcp_mm = frame ? frame->tcp_mm() : frames_.tool_shift().translation();
    motion_.path_deviation().set_tcp(tcp_mm);
    tcp_ = tcps_.number(tcp_mm);
}

void ToolOffset::set(const Eigen::Vector3d& offset_mm) {
    if (offset_mm == offset_mm_) return;
    offset_mm_ = offset_mm;
    notifier_.notify([&](ProgramObserver& observer) { observer.tool_offset(offset_mm); });
    motion_.zones().set_tool_offset(offset_mm, ids_.next());
    update_tcp();
}

}  // namespace gsim::simulation

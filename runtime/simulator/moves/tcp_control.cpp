#include "runtime/simulator/moves/tcp_control.h"

namespace gsim::simulation {

using rrs::Status;
using text::DiagnosticKind;

bool TcpControl::set(const std::optional<Eigen::Vector3d>& offset_mm, const SourceLocation& location) {
    if (!offset_mm && !is_on()) return true;
    clock_.wait();
    std::optional<TcpFrame> frame;
    if (offset_mm) {
        auto tcp_frame_result = tool_.make_tcp_frame(*offset_mm);
        if (!tcp_frame_result)
            return outcome_.fail(DiagnosticKind::machine, tcp_frame_result.error(), location);
        frame = *tcp_frame_result;
    }
    const motion::PlanResult planned =
        motion_.source().check_tcp(frame ? std::optional(frame->tcp_mm()) : std::optional<Eigen::Vector3d>());
    if (!planned && planned.error().status == Status::RRS_SERVICE_NOT_SUPPORTED) {
        return outcome_.fail(DiagnosticKind::mode, "this controller does not support TCP control", location);
    }
    if (!planned) return outcome_.fail(planned.error(), location);
    position_.set_tcp_frame(frame);
    offset_mm_ = offset_mm.value_or(Eigen::Vector3d::Zero());
    if (frame) {
        notifier_.notify_unrecordable("TCP control (G43.4) moves the TCP, not the axes");
    }
    position_.set_joints(motion_.source().position());
    return true;
}

bool TcpControl::renew(const SourceLocation& location) {
    return !is_on() || set(Eigen::Vector3d(offset_mm_), location);
}

}  // namespace gsim::simulation

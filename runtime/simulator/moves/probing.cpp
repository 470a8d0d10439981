#include "runtime/simulator/moves/probing.h"

#include <utility>

namespace gsim::simulation {

using rrs::Status;
using text::DiagnosticKind;

namespace {

constexpr double kPlaneClearance_mm = 1e-9;   // on the plane is not clear of it
constexpr double kFullPathTolerance = 1e-12;  // share of the path
constexpr const char* kNoProbeSurfaceWarning =
    "probes touch at their targets, because nothing defines their contact: use a cell (--cell), a plane "
    "(--probe z=-3.2), or a script (on_probe); with --probe none they never touch";

/// Reduces the time to that of the part of a move that was made.
void shorten(LineMove& move, const AxisVector& from, const AxisVector& stop) {
    const double probe_move = (move.target - from).norm();
    if (move.feed.motion_s && probe_move > 0) *move.feed.motion_s *= (stop - from).norm() / probe_move;
    move.target = stop;
}

}  // namespace

/// Returns the machine coordinates of the tool's end.
Eigen::Vector3d Probing::tool_end_position(const AxisVector& axes) const {
    const Eigen::Vector3d point = position_.space_point(axes);
    return position_.tcp_frame() ? point : Eigen::Vector3d(point - program_.tool().offset_mm());
}

/// Returns no signal if the path does not reach the plane before its solid side is known. That is the side
/// that the first probing move through the plane enters, or from which one moves away.
std::unique_ptr<ProbeSignal> Probing::make_plane_signal(const ProbeMove& move) {
    const auto height = [this](const AxisVector& axes) {
        return tool_end_position(axes)[static_cast<Eigen::Index>(surface_.axis)] - surface_.at_mm;
    };
    if (!solid_side_) {
        const double start_mm = height(position_.axes());
        const double end_mm = height(move.line.target);
        if (start_mm * end_mm > 0 || start_mm == end_mm) return nullptr;
        solid_side_ = (end_mm > start_mm) != move.away ? 1 : -1;
    }
    const double side = move.away ? -*solid_side_ : *solid_side_;
    const double budget_mm = move.away ? kPlaneClearance_mm : 0;
    return std::make_unique<ThresholdSignal>([this, height, side, budget_mm](const rrs::JointPos& joints) {
        return side * height(position_.at(joints)) - budget_mm;
    });
}

std::unique_ptr<ProbeSignal> Probing::make_fraction_signal(const ProbeMove& move) const {
    const AxisVector displacement = move.line.target - position_.axes();
    const double threshold = move.fraction * displacement.norm();
    if (!(displacement.norm() > 0) || move.fraction >= 1 - kFullPathTolerance) return nullptr;
    return std::make_unique<ThresholdSignal>([this, from = position_.axes(), to = displacement.normalized(),
                                              threshold](const rrs::JointPos& joints) {
        return (position_.at(joints) - from).dot(to) - threshold;
    });
}

Probing::SignalOrError Probing::make_cell_signal(bool away) {
    const std::optional<TcpFrame>& tcp_frame = position_.tcp_frame();
    const ToolOffset& tool = program_.tool();
    Eigen::Vector3d tcp_mm =
        tcp_frame ? tcp_frame->tcp_mm() : program_.machine_frames().tool_shift().translation();
    if (!tcp_frame && !tool.offset_mm().isZero()) {
        const auto frame = tool.make_tcp_frame(tool.offset_mm());
        if (!frame) return tl::unexpected(frame.error());
        tcp_mm = frame->tcp_mm();
    }
    auto search = cell_.monitor()->touch_search(tcp_mm, motion_.source().time_s());
    if (!search) return tl::unexpected(search.error().message);
    return std::make_unique<ContactSignal>(*std::move(search), away);
}

bool Probing::ends_at_target(const ProbeMove& move) const {
    if (move.response != ProbeMove::ProbeResponse::unspecified)
        return move.response == ProbeMove::ProbeResponse::at_fraction;
    return surface_.kind == ProbeSurface::Kind::environment && !cell_.is_from_file();
}

bool Probing::senses_cell(const ProbeMove& move) const {
    return move.response == ProbeMove::ProbeResponse::unspecified &&
           surface_.kind == ProbeSurface::Kind::environment && cell_.is_from_file();
}

/// Returns no signal if it does not come before the target.
Probing::SignalOrError Probing::make_signal(const ProbeMove& move) {
    if (move.response == ProbeMove::ProbeResponse::at_fraction) return make_fraction_signal(move);
    if (senses_cell(move)) return make_cell_signal(move.away);
    if (move.response == ProbeMove::ProbeResponse::unspecified && surface_.kind == ProbeSurface::Kind::plane)
        return make_plane_signal(move);
    return nullptr;
}

bool Probing::probe(const ProbeMove& move, ProbeResult& result) {
    if (!groups_.wait(move.line.location)) return false;
    clock_.wait();
    result = {.found = false, .at_start = false, .at = position_.axes()};
    const SignalOrError signal = make_signal(move);
    if (!signal) return outcome_.fail(DiagnosticKind::probe, signal.error(), move.line.location);
    if (*signal && (*signal)->is_active(motion_.source().position())) {
        result.found = result.at_start = true;
        return true;
    }
    if (ends_at_target(move) && move.response == ProbeMove::ProbeResponse::unspecified)
        warnings_.add(kNoProbeSurfaceWarning);
    const bool move_succeeded = make_move(move, signal->get(), result);
    clock_.wait();
    return move_succeeded;
}

bool Probing::make_move(const ProbeMove& move, ProbeSignal* signal, ProbeResult& result) {
    const LineMove& line = move.line;
    const bool rotary = position_.is_rotary_only(line.target);
    if (!feeds_.check(line.feed, rotary, line.location)) return false;
    const auto joints = position_.solve_joints(line.target);
    if (!joints) return outcome_.fail(DiagnosticKind::unreachable, joints.error(), line.location);
    const motion::OvertravelPermit pass(ranges_.begin_move());
    if (const auto in_range = ranges_.check_target(*joints); !in_range)
        return outcome_.fail(in_range.error(), line.location);
    MoveInfo info =
        program_.make_info(MoveKind::probe, line.location, line.feed, feeds_.per_min(line, rotary));
    info.senses_cell = senses_cell(move);
    motion_.recorder().expect(info);
    motion::Move probe_move = program_.make_move(info);
    probe_move.goal.joints = *joints;
    feeds_.apply(line.feed, rotary, probe_move);
    std::optional<rrs::JointPos> at;
    const auto search = [&](const motion::Segment& segment) -> std::optional<double> {
        const auto activation_s = signal->activation_s(segment);
        if (!activation_s) return std::nullopt;
        at = segment.position_at(*activation_s);
        return segment.start_s + *activation_s;
    };
    const motion::EnqueueResult enqueue = signal != nullptr
                                              ? motion_.source().enqueue_until(probe_move, search)
                                              : motion_.source().enqueue(probe_move);
    if (at && !enqueue && enqueue.error().status == Status::RRS_SERVICE_NOT_SUPPORTED) {
        return outcome_.fail(DiagnosticKind::probe,
                             "this controller cannot stop a probe at the contact: it has no StopMotion",
                             line.location);
    }
    result.found = at || (signal == nullptr && ends_at_target(move));
    result.at = at ? position_.at(*at) : line.target;
    return finish_move(enqueue, line, rotary, at.has_value());
}

/// The program continues from the position where the machine has stopped. An observer gets the part of
/// the line that was made.
bool Probing::finish_move(const motion::EnqueueResult& enqueue, LineMove line, bool rotary, bool has_signal) {
    if (has_signal) shorten(line, position_.axes(), position_.at(motion_.source().position()));
    return acceptance_.finish(
        enqueue, line.target, line.location,
        [&](ProgramObserver& observer, const AxisVector& from) { observer.line(from, line, rotary); });
}

}  // namespace gsim::simulation

// Probing moves of a Simulator.

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "runtime/simulator/simulator.h"

namespace gsim::simulation {

using rrs::Status;

namespace {

constexpr double kPlaneClearance_mm = 1e-9;   // on the plane is not clear of it
constexpr double kFullPathTolerance = 1e-12;  // share of the path
constexpr const char* kNoProbeSurfaceWarning =
    "probes touch at their targets, as nothing says what they meet: a cell (--cell), a plane (--probe "
    "z=-3.2), "
    "or a script (on_probe); --probe none lets them pass";

using SignalOrError = tl::expected<std::unique_ptr<ProbeSignal>, std::string>;

/// Reduces the time to that of the part of a move that was made.
void shorten(LineMove& move, const AxisVector& from, const AxisVector& stop) {
    const double probe_move = (move.target - from).norm();
    if (move.feed.motion_s && probe_move > 0) *move.feed.motion_s *= (stop - from).norm() / probe_move;
    move.target = stop;
}

}  // namespace

/// Returns the machine coordinates of the tool's end.
Eigen::Vector3d Simulator::tool_end(const AxisVector& axes) const {
    return tcp_frame_ ? space_point(axes) : Eigen::Vector3d(space_point(axes) - tool_offset_mm_);
}

/// Returns no signal if the path does not reach the plane before its solid side is known. That is the side
/// that the first probing move through the plane enters, or from which one moves away.
std::unique_ptr<ProbeSignal> Simulator::make_plane_signal(const ProbeMove& move) {
    const auto height = [this](const AxisVector& axes) {
        return tool_end(axes)[static_cast<Eigen::Index>(probe_surface_.axis)] - probe_surface_.at_mm;
    };
    if (!solid_side_) {
        const double start_mm = height(position_);
        const double end_mm = height(move.line.target);
        if (start_mm * end_mm > 0 || start_mm == end_mm) return nullptr;
        solid_side_ = (end_mm > start_mm) != move.away ? 1 : -1;
    }
    const double side = move.away ? -*solid_side_ : *solid_side_;
    const double budget_mm = move.away ? kPlaneClearance_mm : 0;
    return std::make_unique<ThresholdSignal>([this, height, side, budget_mm](const rrs::JointPos& joints) {
        return side * height(position_at(joints)) - budget_mm;
    });
}

std::unique_ptr<ProbeSignal> Simulator::make_fraction_signal(const ProbeMove& move) const {
    const AxisVector displacement = move.line.target - position_;
    const double threshold = move.fraction * displacement.norm();
    if (!(displacement.norm() > 0) || move.fraction >= 1 - kFullPathTolerance) return nullptr;
    return std::make_unique<ThresholdSignal>(
        [this, from = position_, to = displacement.normalized(), threshold](const rrs::JointPos& joints) {
            return (position_at(joints) - from).dot(to) - threshold;
        });
}

SignalOrError Simulator::make_cell_signal(bool away) {
    Eigen::Vector3d tcp_mm = tcp_frame_ ? tcp_frame_->tcp_mm() : machine_frames_.tool_shift().translation();
    if (!tcp_frame_ && !tool_offset_mm_.isZero()) {
        const auto frame = make_tcp_frame(tool_offset_mm_);
        if (!frame) return tl::unexpected(frame.error());
        tcp_mm = frame->tcp_mm();
    }
    return cell_->touch_search(tcp_mm, motion_->time_s()).map([away](cell::TouchSearch search) {
        return std::unique_ptr<ProbeSignal>(std::make_unique<ContactSignal>(std::move(search), away));
    });
}

bool Simulator::ends_at_target(const ProbeMove& move) const {
    if (move.response != ProbeMove::ProbeResponse::unspecified)
        return move.response == ProbeMove::ProbeResponse::at_fraction;
    return probe_surface_.kind == ProbeSurface::Kind::environment && !has_cell();
}

bool Simulator::senses_cell(const ProbeMove& move) const {
    return move.response == ProbeMove::ProbeResponse::unspecified &&
           probe_surface_.kind == ProbeSurface::Kind::environment && has_cell();
}

/// Returns no signal if it does not come before the target.
SignalOrError Simulator::make_probe_signal(const ProbeMove& move) {
    if (move.response == ProbeMove::ProbeResponse::at_fraction) return make_fraction_signal(move);
    if (senses_cell(move)) return make_cell_signal(move.away);
    if (move.response == ProbeMove::ProbeResponse::unspecified &&
        probe_surface_.kind == ProbeSurface::Kind::plane)
        return make_plane_signal(move);
    return nullptr;
}

bool Simulator::probe(const ProbeMove& move, ProbeResult& result) {
    if (!wait_for_groups(move.line.location)) return false;
    wait();
    result = {.found = false, .at_start = false, .at = position_};
    const SignalOrError signal = make_probe_signal(move);
    if (!signal) return fail(text::DiagnosticKind::probe, signal.error(), move.line.location);
    if (*signal && (*signal)->is_active(motion_->position())) {
        result.found = result.at_start = true;
        return true;
    }
    if (ends_at_target(move) && move.response == ProbeMove::ProbeResponse::unspecified)
        warn(kNoProbeSurfaceWarning);
    const bool move_succeeded = make_probe_move(move, signal->get(), result);
    wait();
    return move_succeeded;
}

bool Simulator::make_probe_move(const ProbeMove& move, ProbeSignal* signal, ProbeResult& result) {
    LineMove line = move.line;
    const bool rotary = is_rotary_only(line.target);
    if (!check_feed(line.feed, rotary, line.location)) return false;
    const auto joints = solve_joints(line.target);
    if (!joints) return fail(text::DiagnosticKind::unreachable, joints.error(), line.location);
    const motion::OvertravelPermit pass(begin_move());
    if (const auto in_range = check_target(*joints); !in_range)
        return report_plan_error(in_range.error(), line.location);
    MoveInfo info = make_move_info(MoveKind::probe, line.location, feed_per_min(line, rotary));
    info.timed = line.feed.motion_s.has_value();
    apply_override_rules(info, line.feed);
    info.senses_cell = senses_cell(move);
    recorder_.expect(info);
    motion::Move probe_move = make_move(info);
    probe_move.goal.joints = *joints;
    set_move_time(line.feed, rotary, probe_move);
    std::optional<rrs::JointPos> at;
    const auto search = [&](const motion::Segment& segment) -> std::optional<double> {
        const auto activation_s = signal->activation_s(segment);
        if (!activation_s) return std::nullopt;
        at = segment.position_at(*activation_s);
        return segment.start_s + *activation_s;
    };
    const motion::EnqueueResult enqueue =
        signal != nullptr ? motion_->enqueue_until(probe_move, search) : motion_->enqueue(probe_move);
    if (at && !enqueue && enqueue.error().status == Status::RRS_SERVICE_NOT_SUPPORTED)
        return fail(text::DiagnosticKind::probe,
                    "this controller cannot stop a probe where it touches: it has no StopMotion",
                    line.location);
    result.found = at || (signal == nullptr && ends_at_target(move));
    result.at = at ? position_at(*at) : line.target;
    if (at) shorten(line, position_, position_at(motion_->position()));
    if (enqueue) {
        if (observer_ != nullptr) observer_->line(position_, line, rotary);
        position_ = line.target;
    }
    return finish_move(enqueue, line.location);
}

}  // namespace gsim::simulation

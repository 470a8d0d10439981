// Probing moves of a Simulator.

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "runtime/simulator/simulator.h"

namespace gsim::simulation {

using rrs::Status;

namespace {

constexpr double kClear_mm = 1e-9;   // on the plane is not clear of it
constexpr double kWholeWay = 1e-12;  // share of the path
constexpr const char* kTouchesTargets =
    "probes touch at their targets, as nothing says what they meet: a cell (--cell), a plane (--probe "
    "z=-3.2), "
    "or a script (on_probe); --probe none lets them pass";

using SignalOrError = tl::expected<std::unique_ptr<ProbeSignal>, std::string>;

/// Reduces the time to that of the part of a move that was made.
void shorten(LineMove& move, const AxisVector& from, const AxisVector& stop) {
    const double whole = (move.target - from).norm();
    if (move.feed.motion_s && whole > 0) *move.feed.motion_s *= (stop - from).norm() / whole;
    move.target = stop;
}

}  // namespace

/// Returns the machine coordinates of the tool's end.
Eigen::Vector3d Simulator::tool_end(const AxisVector& axes) const {
    return tip_frame_ ? space_point(axes) : Eigen::Vector3d(space_point(axes) - tool_offset_mm_);
}

/// Returns no signal if the path does not reach the plane before its solid side is known. That is the side
/// that the first probing move through the plane enters, or from which one moves away.
std::unique_ptr<ProbeSignal> Simulator::plane_signal(const ProbeMove& move) {
    const auto height = [this](const AxisVector& axes) {
        return tool_end(axes)[static_cast<Eigen::Index>(probe_feels_.axis)] - probe_feels_.at_mm;
    };
    if (!solid_side_) {
        const double start_mm = height(position_);
        const double end_mm = height(move.line.target);
        if (start_mm * end_mm > 0 || start_mm == end_mm) return nullptr;
        solid_side_ = (end_mm > start_mm) != move.away ? 1 : -1;
    }
    const double side = move.away ? -*solid_side_ : *solid_side_;
    const double slack_mm = move.away ? kClear_mm : 0;
    return std::make_unique<MarkSignal>([this, height, side, slack_mm](const rrs::JointPos& joints) {
        return side * height(position_at(joints)) - slack_mm;
    });
}

std::unique_ptr<ProbeSignal> Simulator::part_signal(const ProbeMove& move) const {
    const AxisVector way = move.line.target - position_;
    const double mark = move.part * way.norm();
    if (!(way.norm() > 0) || move.part >= 1 - kWholeWay) return nullptr;
    return std::make_unique<MarkSignal>(
        [this, from = position_, to = way.normalized(), mark](const rrs::JointPos& joints) {
            return (position_at(joints) - from).dot(to) - mark;
        });
}

SignalOrError Simulator::cell_signal(bool away) {
    Eigen::Vector3d tip_mm = tip_frame_ ? tip_frame_->tip_mm() : machine_frames_.tool_shift().translation();
    if (!tip_frame_ && !tool_offset_mm_.isZero()) {
        const auto frame = tip_frame_of(tool_offset_mm_);
        if (!frame) return tl::unexpected(frame.error());
        tip_mm = frame->tip_mm();
    }
    return cell_->touch_search(tip_mm, motion_->time_s()).map([away](cell::TouchSearch search) {
        return std::unique_ptr<ProbeSignal>(std::make_unique<TouchSignal>(std::move(search), away));
    });
}

bool Simulator::touches_target(const ProbeMove& move) const {
    if (move.answer != ProbeMove::Answer::none_given) return move.answer == ProbeMove::Answer::at_part;
    return probe_feels_.kind == ProbeFeels::Kind::surroundings && !has_cell();
}

bool Simulator::feels_cell(const ProbeMove& move) const {
    return move.answer == ProbeMove::Answer::none_given &&
           probe_feels_.kind == ProbeFeels::Kind::surroundings && has_cell();
}

/// Returns no signal if it does not come before the target.
SignalOrError Simulator::probe_signal(const ProbeMove& move) {
    if (move.answer == ProbeMove::Answer::at_part) return part_signal(move);
    if (feels_cell(move)) return cell_signal(move.away);
    if (move.answer == ProbeMove::Answer::none_given && probe_feels_.kind == ProbeFeels::Kind::plane)
        return plane_signal(move);
    return nullptr;
}

bool Simulator::probe(const ProbeMove& move, ProbeResult& result) {
    if (!wait_for_groups(move.line.place)) return false;
    wait();
    result = {.found = false, .at_start = false, .at = position_};
    const SignalOrError signal = probe_signal(move);
    if (!signal) return fail(text::DiagnosticKind::probe, signal.error(), move.line.place);
    if (*signal && (*signal)->is_there(motion_->position())) {
        result.found = result.at_start = true;
        return true;
    }
    if (touches_target(move) && move.answer == ProbeMove::Answer::none_given) warn(kTouchesTargets);
    const bool made = make_probe_move(move, signal->get(), result);
    wait();
    return made;
}

bool Simulator::make_probe_move(const ProbeMove& move, ProbeSignal* signal, ProbeResult& result) {
    LineMove line = move.line;
    const bool rotary = rotary_alone(line.target);
    if (!check_feed(line.feed, rotary, line.place)) return false;
    const auto joints = joints_of(line.target);
    if (!joints) return fail(text::DiagnosticKind::unreachable, joints.error(), line.place);
    const motion::RangePass pass(begin_move());
    if (const auto in_range = check_target(*joints); !in_range) return refused(in_range.error(), line.place);
    MoveInfo info = next_move(MoveKind::probe, line.place, feed_per_min(line, rotary));
    info.timed = line.feed.motion_s.has_value();
    obey_overrides(info, line.feed);
    info.feels_cell = feels_cell(move);
    recorder_.expect(info);
    motion::Move whole = new_move(info);
    whole.goal.joints = *joints;
    set_time_of(line.feed, rotary, whole);
    std::optional<rrs::JointPos> at;
    const auto search = [&](const motion::Segment& segment) -> std::optional<double> {
        const auto comes_s = signal->comes_s(segment);
        if (!comes_s) return std::nullopt;
        at = segment.position_at(*comes_s);
        return segment.start_s + *comes_s;
    };
    const motion::Put put = signal != nullptr ? motion_->put_until(whole, search) : motion_->put(whole);
    if (at && !put && put.error().status == Status::RRS_SERVICE_NOT_SUPPORTED)
        return fail(text::DiagnosticKind::probe,
                    "this controller cannot stop a probe where it touches: it has no StopMotion", line.place);
    result.found = at || (signal == nullptr && touches_target(move));
    result.at = at ? position_at(*at) : line.target;
    if (at) shorten(line, position_, position_at(motion_->position()));
    if (put) {
        if (observer_ != nullptr) observer_->line(position_, line, rotary);
        position_ = line.target;
    }
    return finish_move(put, line.place);
}

}  // namespace gsim::simulation

#include "runtime/report/recorder.h"

#include <algorithm>
#include <span>

#include "runtime/report/limit_name.h"

namespace gsim::simulation {

using motion::Segment;
using motion::SegmentKind;

namespace {

double duration_s(const RecordedMove& move) {
    return move.end_s - move.start_s;
}

}  // namespace

void Recorder::SlowestMoves::add(const RecordedMove& move) {
    const auto begin = moves_.begin();
    const bool full = count_ == std::ssize(moves_);
    if (full && duration_s(move) <= duration_s(moves_.back())) return;
    if (!full) ++count_;
    const auto last = begin + count_ - 1;
    const auto location = std::upper_bound(
        begin, last, move,
        [](const RecordedMove& a, const RecordedMove& b) { return duration_s(a) > duration_s(b); });
    std::move_backward(location, last, last + 1);
    *location = move;
}

std::vector<SlowBlock> Recorder::SlowestMoves::list(const machine::Machine& machine) const {
    std::vector<SlowBlock> blocks;
    for (const RecordedMove& move : std::span(moves_.data(), static_cast<std::size_t>(count_))) {
        blocks.push_back({.location = move.info.location,
                          .kind = move.info.kind,
                          .duration_s = duration_s(move),
                          .length_mm = move.length_mm,
                          .limited_by = move.limited_by ? describe(*move.limited_by, machine) : ""});
    }
    return blocks;
}

Recorder::Recorder(const machine::Machine& machine, const rrs::JointPos& start)
    : machine_(machine), start_(start) {
    for (std::size_t joint = 0; joint < machine.axes.size(); ++joint) {
        const double value = start[static_cast<Eigen::Index>(joint)];
        ranges_[joint] = {value, value};
    }
    move_.end = start;
}

void Recorder::add_output(RunOutput& output) {
    outputs_.push_back(&output);
    output.begin(start_);
}

void Recorder::mark_last_out_of_range(std::uint16_t out_of_range) {
    (pending_moves_.empty() ? move_.info : pending_moves_.back()).out_of_range = out_of_range;
}

// Returns true for a standstill that the controller itself adds, which is part of no move.
bool Recorder::is_between_moves(const Segment& segment) const {
    const rrs::TargetId id = segment.target_id;
    return segment.kind == SegmentKind::rest && !segment.superimposed && in_move_ &&
           move_.info.target_id != id &&
           std::none_of(pending_moves_.begin(), pending_moves_.end(),
                        [id](const MoveInfo& info) { return info.target_id == id; });
}

void Recorder::add_between_moves(const Segment& standstill) {
    add_to_sums(standstill);
    end_s_ = standstill.end_s();
    const MoveInfo info{.target_id = standstill.target_id, .kind = MoveKind::linear};
    for (RunOutput* output : outputs_) output->on_segment(standstill, info);
}

void Recorder::on_segment(const Segment& segment) {
    if (is_between_moves(segment)) return add_between_moves(segment);
    if (!in_move_ || move_.info.target_id != segment.target_id) advance_to_move(segment.target_id);
    add_limit(segment);
    move_.deviation_mm = std::max(move_.deviation_mm, segment.deviation_mm);
    add_to_sums(segment);
    add_to_bounds(segment);
    end_s_ = segment.end_s();
    move_.end_s = end_s_;
    move_.end = segment.end_position();
    move_.length_mm += segment.length_mm;
    if (segment.kind == SegmentKind::circular) {
        move_.arc = segment.arc;
        move_.position_joints = segment.position_joints;
    }
    for (RunOutput* output : outputs_) output->on_segment(segment, move_.info);
}

// Ends moves that wait in front of the one with this id: they got no segment, so they begin and end at the
// same position and time.
void Recorder::advance_to_move(rrs::TargetId id) {
    end_move();
    const auto found = std::find_if(pending_moves_.begin(), pending_moves_.end(),
                                    [id](const MoveInfo& info) { return info.target_id == id; });
    if (found == pending_moves_.end()) {
        begin_move({.target_id = id, .kind = MoveKind::linear});
        in_move_ = false;
        return;
    }
    while (pending_moves_.front().target_id != id) {
        begin_move(pending_moves_.front());
        end_move();
        pending_moves_.pop_front();
    }
    begin_move(pending_moves_.front());
    pending_moves_.pop_front();
}

void Recorder::begin_move(const MoveInfo& info) {
    in_move_ = true;
    move_.info = info;
    move_.start_s = move_.end_s = end_s_;
    move_.length_mm = 0;
    move_.deviation_mm = 0;
    move_.arc.reset();
    move_.limited_by.reset();
    longest_s_ = 0;
}

void Recorder::end_move() {
    const bool counts = in_move_ && (move_.end_s > move_.start_s || move_.info.kind == MoveKind::dwell);
    in_move_ = false;
    if (!counts) return;
    move_.n = ++moves_;
    slowest_.add(move_);
    for (RunOutput* output : outputs_) output->on_move(move_);
}

// Limits a move by the limit of its longest segment, because ramps and corners are short ones.
void Recorder::add_limit(const Segment& segment) {
    if (segment.kind == SegmentKind::rest || segment.duration_s <= longest_s_) return;
    longest_s_ = segment.duration_s;
    move_.limited_by = segment.limited_by;
}

void Recorder::add_to_sums(const Segment& segment) {
    if (segment.kind == SegmentKind::rest) {
        dwell_s_.add(segment.duration_s);
    } else if (move_.info.kind == MoveKind::rapid) {
        rapid_s_.add(segment.duration_s);
        rapid_mm_.add(segment.length_mm);
        if (!move_.info.enabled_overrides.rapid) rapid_locked_s_.add(segment.duration_s);
    } else {
        feed_s_.add(segment.duration_s);
        feed_mm_.add(segment.length_mm);
        if (!move_.info.enabled_overrides.feed) feed_locked_s_.add(segment.duration_s);
        if (move_.info.follows_spindle && !move_.info.enabled_overrides.spindle)
            spindle_locked_s_.add(segment.duration_s);
        if (move_.info.process_on) process_on_mm_.add(segment.length_mm);
    }
}

void Recorder::add_to_bounds(const Segment& segment) {
    if (segment.kind == SegmentKind::rest && !segment.superimposed) return;
    for (int joint = 0; joint < segment.end.size(); ++joint) {
        motion::Range& range = ranges_[static_cast<std::size_t>(joint)];
        // Almost every segment stays within the range of earlier ones, which is cheaper to check than its
        // travel.
        if (segment.is_certainly_within(range, joint)) continue;
        const motion::Range travel = segment.joint_range(joint);
        range.min = std::min(range.min, travel.min);
        range.max = std::max(range.max, travel.max);
    }
}

std::vector<AxisBounds> Recorder::bounds() const {
    std::vector<AxisBounds> bounds;
    for (std::size_t joint = 0; joint < machine_.axes.size(); ++joint) {
        const machine::Axis& axis = machine_.axes[joint];
        bounds.push_back({.letter = axis.letter,
                          .rotary = axis.kind == machine::AxisKind::rotary,
                          .min = axis_value(axis, ranges_[joint].min),
                          .max = axis_value(axis, ranges_[joint].max),
                          .limit_min = axis.min,
                          .limit_max = axis.max});
    }
    return bounds;
}

// Ends the last move when the controller is at standstill.
void Recorder::finish(Report& report) {
    move_.end_s = end_s_;
    end_move();
    pending_moves_.clear();  // never made: the run ended before
    for (RunOutput* output : outputs_) output->end(end_s_);
    report.source.machine = machine_.name;
    report.cycle_time_s = end_s_;
    report.times.rapid_s = rapid_s_.value();
    report.times.feed_s = feed_s_.value();
    report.times.dwell_s = dwell_s_.value();
    report.distances.rapid_mm = rapid_mm_.value();
    report.distances.feed_mm = feed_mm_.value();
    report.distances.process_on_mm = process_on_mm_.value();
    report.counts.moves = moves_;
    if (report.overrides) {
        report.overrides->feed_locked_s = feed_locked_s_.value();
        report.overrides->rapid_locked_s = rapid_locked_s_.value();
        report.overrides->spindle_locked_s = spindle_locked_s_.value();
    }
    report.bounds = bounds();
    report.slowest = slowest_.list(machine_);
}

}  // namespace gsim::simulation

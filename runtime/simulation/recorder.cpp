#include "runtime/simulation/recorder.h"

#include <algorithm>
#include <cmath>

namespace gsim::simulation {

using motion::Segment;
using motion::SegmentKind;

void Recorder::Sum::add(double term) {
    const double next = sum_ + term;
    lost_ += std::abs(sum_) >= std::abs(term) ? (sum_ - next) + term : (term - next) + sum_;
    sum_ = next;
}

void Recorder::Slowest::add(const SlowBlock& block) {
    const auto begin = blocks_.begin();
    const bool full = count_ == std::ssize(blocks_);
    if (full && block.duration_s <= blocks_.back().duration_s) return;
    if (!full) ++count_;
    const auto last = begin + count_ - 1;
    const auto place = std::upper_bound(begin, last, block, [](const SlowBlock& a, const SlowBlock& b) {
        return a.duration_s > b.duration_s;
    });
    std::move_backward(place, last, last + 1);
    *place = block;
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

void Recorder::take(const Segment& segment) {
    if (!in_move_ || move_.info.target_id != segment.target_id) go_to_move(segment.target_id);
    add_to_sums(segment);
    add_to_bounds(segment);
    end_s_ = segment.end_s();
    move_.end_s = end_s_;
    move_.end = segment.end;
    move_.length_mm += segment.length_mm;
    if (segment.kind == SegmentKind::circular) {
        move_.arc = segment.arc;
        move_.position_joints = segment.position_joints;
    }
    for (RunOutput* output : outputs_) output->take(segment, move_.info);
}

// Moves that wait in front of the one with this id got no segment: they end where and when they begin.
void Recorder::go_to_move(rrs::TargetId id) {
    end_move();
    const auto found = std::find_if(waiting_.begin(), waiting_.end(),
                                    [id](const MoveInfo& info) { return info.target_id == id; });
    if (found == waiting_.end()) {
        begin_move({.target_id = id, .kind = MoveKind::linear});
        in_move_ = false;
        return;
    }
    while (waiting_.front().target_id != id) {
        begin_move(waiting_.front());
        end_move();
        waiting_.pop_front();
    }
    begin_move(waiting_.front());
    waiting_.pop_front();
}

void Recorder::begin_move(const MoveInfo& info) {
    in_move_ = true;
    move_.info = info;
    move_.start_s = move_.end_s = end_s_;
    move_.length_mm = 0;
    move_.arc.reset();
}

void Recorder::end_move() {
    const bool counts = in_move_ && (move_.end_s > move_.start_s || move_.info.kind == MoveKind::dwell);
    in_move_ = false;
    if (!counts) return;
    move_.n = ++moves_;
    slowest_.add({.place = move_.info.place,
                  .kind = move_.info.kind,
                  .duration_s = move_.end_s - move_.start_s,
                  .length_mm = move_.length_mm});
    for (RunOutput* output : outputs_) output->take(move_);
}

void Recorder::add_to_sums(const Segment& segment) {
    if (segment.kind == SegmentKind::rest) {
        dwell_s_.add(segment.duration_s);
    } else if (move_.info.kind == MoveKind::rapid) {
        rapid_s_.add(segment.duration_s);
        rapid_mm_.add(segment.length_mm);
    } else {
        feed_s_.add(segment.duration_s);
        feed_mm_.add(segment.length_mm);
        if (move_.info.jet_on) jet_on_mm_.add(segment.length_mm);
    }
}

void Recorder::add_to_bounds(const Segment& segment) {
    if (segment.kind == SegmentKind::rest) return;
    for (int joint = 0; joint < segment.end.size(); ++joint) {
        motion::Range& range = ranges_[static_cast<std::size_t>(joint)];
        const motion::Range way = segment.joint_range(joint);
        range.min = std::min(range.min, way.min);
        range.max = std::max(range.max, way.max);
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

void Recorder::finish(Report& report) {
    end_move();
    waiting_.clear();  // never made: the run ended before
    for (RunOutput* output : outputs_) output->end(end_s_);
    report.machine = machine_.name;
    report.cycle_time_s = end_s_;
    report.rapid_s = rapid_s_.value();
    report.feed_s = feed_s_.value();
    report.dwell_s = dwell_s_.value();
    report.rapid_mm = rapid_mm_.value();
    report.feed_mm = feed_mm_.value();
    report.jet_on_mm = jet_on_mm_.value();
    report.moves = moves_;
    report.bounds = bounds();
    report.slowest = slowest_.list();
}

}  // namespace gsim::simulation

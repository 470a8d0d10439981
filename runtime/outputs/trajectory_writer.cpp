#include "runtime/outputs/trajectory_writer.h"

#include <iterator>

#include "base/text/format.h"
#include "base/text/json_text.h"
#include "base/units.h"

namespace gsim::simulation {

namespace {

using text::append_number;

}  // namespace

TrajectoryWriter::TrajectoryWriter(TextStream& out, const machine::Machine& machine, double step_s,
                                   double max_time_s, std::uint64_t max_samples)
    : Sampler(step_s, max_time_s), out_(out), machine_(machine), max_samples_(max_samples) {}

void TrajectoryWriter::begin(const rrs::JointPos& start) {
    Sampler::begin(start);
    if (following_) following_->begin(start);
    write_header();
}

void TrajectoryWriter::on_segment(const motion::Segment& segment, const MoveInfo& info) {
    info_ = info;
    has_entered_segment_ = false;
    Sampler::on_segment(segment, info);
    if (!following_) return;
    enter_segment(segment);
    following_->leave();
}

void TrajectoryWriter::enter_segment(const motion::Segment& segment) {
    if (!has_entered_segment_) following_->enter(segment, info_);
    has_entered_segment_ = true;
}

void TrajectoryWriter::end(double end_s) {
    at_end_ = true;
    Sampler::end(end_s);
}

void TrajectoryWriter::write_header() {
    fmt::memory_buffer& out = out_.buffer();
    text::append_text(out, "t_s,line,");
    for (const machine::Axis& axis : machine_.axes) {
        const char letter = static_cast<char>(axis.letter - 'A' + 'a');
        text::append_format(out, "{}_{},", letter, axis.kind == machine::AxisKind::linear ? "mm" : "deg");
    }
    text::append_format(out, "speed_mm_s");
    if (efforts_) {
        for (const machine::Axis& axis : machine_.axes) {
            const char letter = static_cast<char>(axis.letter - 'A' + 'a');
            text::append_format(out, ",{}_{}", letter, axis.kind == machine::AxisKind::linear ? "n" : "nm");
        }
        text::append_format(out, ",power_w");
    }
    if (following_) {
        for (const machine::Axis& axis : machine_.axes) {
            const char letter = static_cast<char>(axis.letter - 'A' + 'a');
            text::append_format(out, ",{}_error_{}", letter,
                                axis.kind == machine::AxisKind::linear ? "mm" : "deg");
        }
        text::append_format(out, ",tip_x_mm,tip_y_mm,tip_z_mm,contour_mm");
    }
    out_.end_line();
}

void TrajectoryWriter::write_efforts(const rrs::JointPos& joints) {
    motion::Segment standstill;
    standstill.start = standstill.end = joints;
    const dynamics::EffortSample sample =
        segment() != nullptr ? efforts_->at(*segment(), time_in_segment_s()) : efforts_->at(standstill, 0);
    fmt::memory_buffer& out = out_.buffer();
    for (const double effort : sample.efforts) {
        out.push_back(',');
        append_number(out, effort);
    }
    out.push_back(',');
    append_number(out, sample.powers_w.sum());
}

// Counts an instant between two segments, and the end, as standstill.
void TrajectoryWriter::write_following(double t_s) {
    if (segment() != nullptr) enter_segment(*segment());
    following_->go_to(t_s);
    const FollowingInstant instant = following_->at(t_s);
    fmt::memory_buffer& out = out_.buffer();
    const auto append = [&](double value) {
        out.push_back(',');
        append_number(out, value);
    };
    for (std::size_t i = 0; i < machine_.axes.size(); ++i) {
        const double error = instant.errors[static_cast<Eigen::Index>(i)];
        append(machine_.axes[i].kind == machine::AxisKind::linear ? error : error / kRadPerDeg);
    }
    for (const double coordinate : instant.tcp_mm) append(coordinate);
    if (instant.contour_error_mm) {
        append(*instant.contour_error_mm);
    } else {
        out.push_back(',');
    }
}

bool TrajectoryWriter::sample(double t_s, const rrs::JointPos& joints, double speed_mm_s,
                              std::uint32_t line) {
    is_truncated_ = is_truncated_ || (!at_end_ && samples_ >= max_samples_);
    if (is_truncated_ && !at_end_) return false;
    fmt::memory_buffer& out = out_.buffer();
    append_number(out, t_s);
    text::append_format(out, ",{},", line);
    for (std::size_t i = 0; i < machine_.axes.size(); ++i) {
        append_number(out, axis_value(machine_.axes[i], joints[static_cast<Eigen::Index>(i)]));
        out.push_back(',');
    }
    append_number(out, speed_mm_s);
    if (efforts_) write_efforts(joints);
    if (following_) write_following(t_s);
    out_.end_line();
    ++samples_;
    return !out_.failed();
}

}  // namespace gsim::simulation

#include "runtime/simulation/trajectory_writer.h"

#include <algorithm>
#include <iterator>
#include <stdexcept>

#include "base/text/json_text.h"

namespace gsim::simulation {

namespace {

using text::append_number;

// Instants closer than this show as equal; the later one, the start of the next segment, is written.
constexpr double kSameInstant_s = 0.5e-9;

}  // namespace

TrajectoryWriter::TrajectoryWriter(TextStream& out, const machine::Machine& machine, double step_s,
                                   double max_time_s, std::uint64_t most_samples)
    : out_(out), machine_(machine), step_s_(step_s), max_time_s_(max_time_s), most_samples_(most_samples) {
    if (!(step_s >= kMinStep_s)) throw std::invalid_argument("the step of a trajectory is less than 1e-6 s");
}

void TrajectoryWriter::begin(const rrs::JointPos& start) {
    position_ = start;
    write_header();
}

void TrajectoryWriter::write_header() {
    fmt::memory_buffer& out = out_.buffer();
    auto end = std::back_inserter(out);
    fmt::format_to(end, "t_s,line,");
    for (const machine::Axis& axis : machine_.axes) {
        const char letter = static_cast<char>(axis.letter - 'A' + 'a');
        fmt::format_to(end, "{}_{},", letter, axis.kind == machine::AxisKind::linear ? "mm" : "deg");
    }
    fmt::format_to(end, "speed_mm_s");
    out_.end_line();
}

bool TrajectoryWriter::due(double before_s) {
    if (!(next_s() < before_s - kSameInstant_s && next_s() <= max_time_s_) || out_.failed()) return false;
    cut_short_ = next_ >= most_samples_;
    return !cut_short_;
}

void TrajectoryWriter::take(const motion::Segment& segment, const MoveInfo& info) {
    for (; due(segment.start_s); ++next_) write_sample(next_s(), position_, 0);
    line_ = info.place.line;
    for (; due(segment.end_s()); ++next_) {
        const double t_s = std::max(0.0, next_s() - segment.start_s);
        write_sample(next_s(), segment.position_at(t_s), segment.path_speed_mm_s(t_s));
    }
    position_ = segment.end_position();
}

void TrajectoryWriter::end(double end_s) {
    write_sample(end_s, position_, 0);
}

void TrajectoryWriter::write_sample(double t_s, const rrs::JointPos& joints, double speed_mm_s) {
    fmt::memory_buffer& out = out_.buffer();
    append_number(out, t_s);
    fmt::format_to(std::back_inserter(out), ",{},", line_);
    for (std::size_t i = 0; i < machine_.axes.size(); ++i) {
        append_number(out, axis_value(machine_.axes[i], joints[static_cast<Eigen::Index>(i)]));
        out.push_back(',');
    }
    append_number(out, speed_mm_s);
    out_.end_line();
}

}  // namespace gsim::simulation

#include "calibrate/times/timed_interval.h"

#include <Eigen/Core>
#include <algorithm>
#include <optional>
#include <variant>

namespace gsim::calibrate {

namespace {

constexpr double kMinMarkSamples = 30;  // of two marks: what a clock is off by is then a few percent
constexpr double kMinMarkInterval_s = 0.2;

using simulation::MotionLog;

/// Returns the position of X, Y and Z at the end of a move, mm; empty if the log does not contain it.
std::optional<Eigen::Vector3d> end_position(const simulation::MotionRequest& motion_request,
                                            const machine::Machine& machine) {
    const auto* move = std::get_if<motion::Move>(&motion_request);
    if (move == nullptr || move->goal.pose || move->tcp_mm) return std::nullopt;
    Eigen::Vector3d position_mm = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < machine.axes.size(); ++i) {
        const machine::Axis& axis = machine.axes[i];
        if (axis.kind == machine::AxisKind::linear && axis.letter >= 'X' && axis.letter <= 'Z')
            position_mm[axis.letter - 'X'] =
                machine::axis_value(axis, move->goal.joints[static_cast<Eigen::Index>(i)]);
    }
    return position_mm;
}

struct Mark {
    std::size_t move = 0;
    double t_s = 0;
};

std::vector<Mark> find_timed_moves(const RecordedRun& run, const MotionLog& log,
                                   const machine::Machine& machine) {
    std::vector<std::size_t> moves;
    std::vector<Eigen::Vector3d> positions_mm;
    for (std::size_t i = 0; i < log.requests().size(); ++i) {
        const auto position_mm = end_position(log.requests()[i], machine);
        if (!position_mm) continue;
        moves.push_back(i);
        positions_mm.push_back(*position_mm);
    }
    const auto passages = passage_times_s(run.samples, positions_mm);
    std::vector<Mark> marks;
    for (std::size_t i = 0; i < moves.size(); ++i) {
        if (passages[i]) marks.push_back({moves[i], *passages[i]});
    }
    return marks;
}

double period_s(const std::vector<MotionSample>& samples) {
    return (samples.back().t_s - samples.front().t_s) / static_cast<double>(samples.size() - 1);
}

rrs::TargetId move_target_id(const MotionLog& log, std::size_t move) {
    return std::get<motion::Move>(log.requests()[move]).target_id;
}

}  // namespace

std::vector<TimedInterval> timed_intervals(const RecordedRun& run, const MotionLog& log,
                                           const machine::Machine& machine) {
    const auto span = motion_span(run.samples);
    if (!span) return {{.time_s = run.time_s}};
    const double clock_error_s = period_s(run.samples);
    const double min_interval_s = std::max(kMinMarkSamples * clock_error_s, kMinMarkInterval_s);
    std::vector<TimedInterval> data;
    TimedInterval next{.clock_error_s = clock_error_s};
    double previous_s = span->start_s;
    for (const Mark& mark : find_timed_moves(run, log, machine)) {
        if (mark.t_s < previous_s + min_interval_s || mark.t_s > span->end_s - min_interval_s) continue;
        next.to = mark.move;
        next.time_s = mark.t_s - previous_s;
        data.push_back(next);
        next.from = mark.move;
        previous_s = mark.t_s;
    }
    next.to = TimedInterval::kRunBoundary;
    next.time_s = span->end_s - previous_s;
    data.push_back(next);
    return data;
}

std::optional<TimeSpan> replay_span(std::span<const simulation::ReplayedMove> moves) {
    const auto is_motion = [](const simulation::ReplayedMove& move) { return !move.is_standstill; };
    const auto is_for_word = [](const simulation::ReplayedMove& move) { return move.is_for_word; };
    const auto first = std::find_if(moves.begin(), moves.end(), is_motion);
    if (first == moves.end()) return std::nullopt;
    const auto last = std::find_if(moves.rbegin(), moves.rend(), is_motion);
    const bool words_before = std::any_of(moves.begin(), first, is_for_word);
    const bool words_after = std::any_of(moves.rbegin(), last, is_for_word);
    return TimeSpan{words_before ? first->start_s : moves.front().start_s,
                    words_after ? last->end_s : moves.back().end_s};
}

double interval_time_s(const TimedInterval& datum, const MotionLog& log,
                       std::span<const simulation::ReplayedMove> moves) {
    const auto span = replay_span(moves);
    if (!span) return 0;
    const auto move_end_s = [&](std::size_t move) {
        const rrs::TargetId target = move_target_id(log, move);
        const auto found = std::lower_bound(
            moves.begin(), moves.end(), target,
            [](const simulation::ReplayedMove& each, rrs::TargetId id) { return each.target_id < id; });
        return found == moves.end() ? moves.back().end_s : found->end_s;
    };
    const double start_s = datum.from == TimedInterval::kRunBoundary ? span->start_s : move_end_s(datum.from);
    const double end_s = datum.to == TimedInterval::kRunBoundary ? span->end_s : move_end_s(datum.to);
    return end_s - start_s;
}

}  // namespace gsim::calibrate

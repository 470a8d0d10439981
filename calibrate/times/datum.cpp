#include "calibrate/times/datum.h"

#include <Eigen/Core>
#include <algorithm>
#include <optional>
#include <variant>

namespace gsim::calibrate {

namespace {

constexpr double kSamplesApart = 30;  // of two marks: what a clock is off by is then a few percent
constexpr double kLeastApart_s = 0.2;

using simulation::MotionLog;

/// Returns the position of X, Y and Z at the end of a move, mm; empty if the log does not contain it.
std::optional<Eigen::Vector3d> place_of(const simulation::MotionAsk& ask, const machine::Machine& machine) {
    const auto* move = std::get_if<motion::Move>(&ask);
    if (move == nullptr || move->goal.pose || move->tip_mm) return std::nullopt;
    Eigen::Vector3d place_mm = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < machine.axes.size(); ++i) {
        const machine::Axis& axis = machine.axes[i];
        if (axis.kind == machine::AxisKind::linear && axis.letter >= 'X' && axis.letter <= 'Z')
            place_mm[axis.letter - 'X'] =
                machine::axis_value(axis, move->goal.joints[static_cast<Eigen::Index>(i)]);
    }
    return place_mm;
}

struct Mark {
    std::size_t move = 0;
    double t_s = 0;
};

std::vector<Mark> marks_of(const RecordedRun& run, const MotionLog& log, const machine::Machine& machine) {
    std::vector<std::size_t> moves;
    std::vector<Eigen::Vector3d> places_mm;
    for (std::size_t i = 0; i < log.asks().size(); ++i) {
        const auto place_mm = place_of(log.asks()[i], machine);
        if (!place_mm) continue;
        moves.push_back(i);
        places_mm.push_back(*place_mm);
    }
    const auto passages = passages_s(run.samples, places_mm);
    std::vector<Mark> marks;
    for (std::size_t i = 0; i < moves.size(); ++i) {
        if (passages[i]) marks.push_back({moves[i], *passages[i]});
    }
    return marks;
}

double period_s(const std::vector<MotionSample>& samples) {
    return (samples.back().t_s - samples.front().t_s) / static_cast<double>(samples.size() - 1);
}

rrs::TargetId target_of(const MotionLog& log, std::size_t move) {
    return std::get<motion::Move>(log.asks()[move]).target_id;
}

}  // namespace

std::vector<Datum> data_of(const RecordedRun& run, const MotionLog& log, const machine::Machine& machine) {
    const auto span = motion_span(run.samples);
    if (!span) return {{.time_s = run.time_s}};
    const double clock_s = period_s(run.samples);
    const double apart_s = std::max(kSamplesApart * clock_s, kLeastApart_s);
    std::vector<Datum> data;
    Datum next{.clock_s = clock_s};
    double before_s = span->start_s;
    for (const Mark& mark : marks_of(run, log, machine)) {
        if (mark.t_s < before_s + apart_s || mark.t_s > span->end_s - apart_s) continue;
        next.to = mark.move;
        next.time_s = mark.t_s - before_s;
        data.push_back(next);
        next.from = mark.move;
        before_s = mark.t_s;
    }
    next.to = Datum::kOutside;
    next.time_s = span->end_s - before_s;
    data.push_back(next);
    return data;
}

std::optional<Span> span_of(std::span<const simulation::ReplayedMove> moves) {
    const auto goes = [](const simulation::ReplayedMove& move) { return !move.rests; };
    const auto of_word = [](const simulation::ReplayedMove& move) { return move.of_word; };
    const auto first = std::find_if(moves.begin(), moves.end(), goes);
    if (first == moves.end()) return std::nullopt;
    const auto last = std::find_if(moves.rbegin(), moves.rend(), goes);
    const bool words_before = std::any_of(moves.begin(), first, of_word);
    const bool words_behind = std::any_of(moves.rbegin(), last, of_word);
    return Span{words_before ? first->start_s : moves.front().start_s,
                words_behind ? last->end_s : moves.back().end_s};
}

double time_of(const Datum& datum, const MotionLog& log, std::span<const simulation::ReplayedMove> moves) {
    const auto span = span_of(moves);
    if (!span) return 0;
    const auto end_of = [&](std::size_t move) {
        const rrs::TargetId target = target_of(log, move);
        const auto found = std::lower_bound(
            moves.begin(), moves.end(), target,
            [](const simulation::ReplayedMove& each, rrs::TargetId id) { return each.target_id < id; });
        return found == moves.end() ? moves.back().end_s : found->end_s;
    };
    const double start_s = datum.from == Datum::kOutside ? span->start_s : end_of(datum.from);
    const double end_s = datum.to == Datum::kOutside ? span->end_s : end_of(datum.to);
    return end_s - start_s;
}

}  // namespace gsim::calibrate

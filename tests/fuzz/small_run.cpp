#include "tests/fuzz/small_run.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include <fmt/format.h>

#include "base/text/json.h"
#include "engine/src/run/word_table.h"
#include "runtime/monitors/cell_monitor.h"
#include "runtime/script/engine/engine.h"
#include "runtime/simulator/simulator.h"

namespace gsim::fuzz {
namespace {

using simulation::Report;
using simulation::RunStatus;

constexpr std::size_t kMemory_bytes = std::size_t{48} << 20U;
constexpr std::uint64_t kSteps = 200'000;
constexpr simulation::RunLimits kLimits{.max_time_s = 600, .max_blocks = 300};
/// Number of programs of which one is run twice, by its text: reloading the library takes most of the time.
constexpr std::size_t kRunTwice = 8;
/// Tolerance of joint values: the end of a segment is stored, not computed from its law.
constexpr double kJoin = 1e-6;
constexpr double kTimeSlack = 1e-9;

/// Check of what a run passes on: values do not jump, and time does not run back.
class Continuity final : public simulation::RunOutput {
  public:
    /// `sampled`: the controller is a module, with perhaps another position for the start of motion.
    explicit Continuity(bool is_sampled) : sampled_(is_sampled) {}

    const std::optional<std::string>& broken() const { return broken_; }

    void begin(const rrs::JointPos& start) override { at_ = start; }
    void on_segment(const motion::Segment& segment, const simulation::MoveInfo& /*info*/) override {
        if (broken_) return;
        if (!(segment.duration_s >= 0) || !(std::abs(segment.start_s - end_s_) <= slack_s()))
            note(segment, fmt::format("begins at {} s, lasts {} s and follows on {} s", segment.start_s,
                                      segment.duration_s, end_s_));
        if (!segment.end.allFinite()) note(segment, "ends nowhere");
        if (!sampled_ && (segment.start - at_).cwiseAbs().maxCoeff() > kJoin)
            note(segment, "begins where none ended");
        end_s_ = segment.end_s();
        at_ = segment.end_position();
    }

  private:
    double slack_s() const { return kTimeSlack * (1 + end_s_); }
    void note(const motion::Segment& segment, std::string_view what) {
        if (!broken_) broken_ = fmt::format("a segment of target {} {}", segment.target_id, what);
    }

    bool sampled_;
    rrs::JointPos at_;
    double end_s_ = 0;
    std::optional<std::string> broken_;
};

script::Script script_of(const SmallRun& run) {
    script::Script script = script::Script::from_text(run.lua, run.file_name, run.line_offset);
    script.dialect = run.dialect;
    return script;
}

bool all_finite(const Report& report) {
    const std::array values{report.cycle_time_s,      report.times.rapid_s,
                            report.times.feed_s,      report.times.dwell_s,
                            report.times.words_s,     report.distances.rapid_mm,
                            report.distances.feed_mm, report.distances.process_on_mm};
    return std::all_of(values.begin(), values.end(), [](double f) { return std::isfinite(f) && f >= 0; });
}

double greatest_step(const machine::Machine& machine) {
    double step = 0;
    for (const machine::Axis& axis : machine.axes) step = std::max(step, axis.step);
    return step;
}

std::optional<std::string> fault_of_bounds(const Report& report, double step) {
    for (const simulation::AxisBounds& axis : report.bounds) {
        if (!(axis.min <= axis.max))
            return fmt::format("axis {} goes from {} to {}", axis.letter, axis.min, axis.max);
        const double slack = kJoin + step / 2;  // a controller moves to the step that is nearest to a target
        const bool within = axis.min >= axis.limit_min - slack && axis.max <= axis.limit_max + slack;
        if (!within && report.status == RunStatus::completed)
            return fmt::format("the run completed, and axis {} went from {} to {}, beyond {} to {}",
                               axis.letter, axis.min, axis.max, axis.limit_min, axis.limit_max);
    }
    return std::nullopt;
}

/// Moves of a simulator from its position, until one of them is rejected.
class ShortMoves {
  public:
    explicit ShortMoves(simulation::Simulator& simulator)
        : simulator_(simulator), home_(simulator.position().axes()) {}

    void make() {
        using simulation::MoveKind;
        simulator_.program().settings().set_path_mode(rrs::PathMode::continuous, 0, 0);
        line(MoveKind::rapid, {10, 10, 5});
        line(MoveKind::linear, {50, 10, 5});
        line(MoveKind::linear, {50, 20, 5});
        line(MoveKind::linear, {51, 20.5, 5.5});
        line(MoveKind::linear, {52, 22, 5});
        arc({52, 32, 5}, {52, 42, 5});
        goes_on_ = goes_on_ && simulator_.dwells().enqueue(kDwell_s, {});
        line(MoveKind::rapid, {0, 0, 0});
    }

  private:
    static constexpr double kFeed_mm_min = 3000;
    static constexpr double kDwell_s = 0.1;

    std::optional<Eigen::Index> linear_axis(char letter) const {
        const machine::Machine& machine = simulator_.machine();
        const auto axis = machine.find(letter);
        if (!axis || machine.axes[*axis].kind != machine::AxisKind::linear) return std::nullopt;
        return static_cast<Eigen::Index>(*axis);
    }

    simulation::AxisVector at(const Eigen::Vector3d& offset_mm) const {
        simulation::AxisVector target = home_;
        for (const int i : {0, 1, 2}) {
            if (const auto axis = linear_axis(static_cast<char>('X' + i))) target[*axis] += offset_mm[i];
        }
        return target;
    }

    void line(simulation::MoveKind kind, const Eigen::Vector3d& to_mm) {
        simulation::LineMove move;
        move.kind = kind;
        move.target = at(to_mm);
        move.feed.linear_mm_min = kFeed_mm_min;
        goes_on_ = goes_on_ && simulator_.moves().enqueue(move);
    }

    void arc(const Eigen::Vector3d& center_mm, const Eigen::Vector3d& to_mm) {
        const auto x = linear_axis('X');
        const auto y = linear_axis('Y');
        if (!x || !y) return;
        simulation::ArcMove move;
        move.kind = simulation::MoveKind::arc_ccw;
        move.target = at(to_mm);
        const simulation::AxisVector center = at(center_mm);
        move.center_mm = {center[*x], center[*y], 0};
        move.sweep_rad = std::numbers::pi;
        move.feed.linear_mm_min = kFeed_mm_min;
        goes_on_ = goes_on_ && simulator_.moves().enqueue(move);
    }

    simulation::Simulator& simulator_;
    simulation::AxisVector home_;
    bool goes_on_ = true;
};

}  // namespace

RunResult run_once(const SmallRun& run) {
    Continuity continuity(false);
    simulation::Simulator simulator(run.machine, kLimits);
    simulator.add_output(continuity);
    script::Engine::Options options;
    options.limits.memory_bytes = kMemory_bytes;
    options.limits.steps = kSteps;
    options.dialect = run.dialect;
    options.codes = engine::word_table(*grammar::find_dialect(run.dialect));
    script::Engine engine(simulator, options);
    engine.run(script_of(run));
    RunResult result{
        .report = simulator.finish(run.file_name), .greatest_step = greatest_step(run.machine), .broken = {}};
    engine.report(result.report);
    result.broken = continuity.broken();
    return result;
}

RunResult run_moves(MovesRun run) {
    Continuity continuity(run.module.has_value());
    simulation::Simulator simulator(run.machine, kLimits, std::move(run.module));
    simulator.add_output(continuity);
    std::optional<simulation::CellMonitor> cell;
    if (run.cell) simulator.set_cell(cell.emplace(*std::move(run.cell), run.machine));
    if (!run.overrides.changes().empty()) simulator.motion().set_overrides(run.overrides);
    ShortMoves(simulator).make();
    return {.report = simulator.finish("moves"),
            .greatest_step = greatest_step(simulator.machine()),
            .broken = continuity.broken()};
}

std::optional<std::string> fault_of_report(const RunResult& result) {
    const Report& report = result.report;
    if (!nlohmann::json::accept(simulation::to_json(report))) return "the report is no JSON";
    if (simulation::to_text(report).empty()) return "the report for people is empty";
    if (!all_finite(report)) return "a figure of the report is not finite, or below 0";
    const double parts_s = report.times.rapid_s + report.times.feed_s + report.times.dwell_s;
    if (!(std::abs(parts_s - report.cycle_time_s) <= kTimeSlack * (1 + report.cycle_time_s)))
        return fmt::format("the cycle time is {} s, its parts are {} s", report.cycle_time_s, parts_s);
    const bool ended = report.status == RunStatus::alarm || report.status == RunStatus::stopped;
    if (ended != report.alarm.has_value()) return "the status does not go with the alarm";
    if (report.alarm && report.alarm->message.empty()) return "an alarm without a sentence";
    if (report.alarm && report.alarm->location.file >= std::max<std::size_t>(report.source.files.size(), 1))
        return "the place of the alarm is in no file";
    return fault_of_bounds(report, result.greatest_step);
}

Outcome outcome_of(const RunResult& result) {
    if (result.broken) return broken(*result.broken);
    if (auto violation = fault_of_report(result)) return broken(*std::move(violation));
    const RunStatus status = result.report.status;
    return status == RunStatus::completed || status == RunStatus::violations ? accepted() : rejected();
}

Outcome check_run(const SmallRun& run) {
    const RunResult first = run_once(run);
    const bool repeated = std::hash<std::string>()(run.lua) % kRunTwice == 0;
    if (repeated && simulation::to_json(first.report) != simulation::to_json(run_once(run).report))
        return broken("two runs of one program differ");
    return outcome_of(first);
}

}  // namespace gsim::fuzz

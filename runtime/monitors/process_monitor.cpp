#include "runtime/monitors/process_monitor.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace gsim::simulation {

using text::DiagnosticKind;

namespace {

constexpr double kHeightStepsPerMm = 1000;  // heights are distinguished by full micrometres
constexpr double kMinDistance_mm = 1e-6;
constexpr double kVerticalLimit = 1 - 1e-9;  // of a normal: arcs in the XY plane
constexpr std::size_t kMaxPlanes = 10'000;

bool is_feed(MoveKind kind) {
    return kind != MoveKind::rapid && kind != MoveKind::dwell && kind != MoveKind::probe;
}

ProcessFinding make_finding(const RecordedMove& move, text::DiagnosticKind kind, std::string message) {
    return {.t_s = move.start_s, .location = move.info.location, .kind = kind, .message = std::move(message)};
}

}  // namespace

ProcessMonitor::ProcessMonitor(const machine::Machine& machine)
    : machine_(machine), x_axis_(machine.find('X')), y_axis_(machine.find('Y')), z_axis_(machine.find('Z')) {
    if (machine.process) process_ = machine::name(machine.process->kind);
}

void ProcessMonitor::add(ProcessFinding finding) {
    ++findings_.count;
    if (findings_.list.size() < kMaxFindings) findings_.list.push_back(std::move(finding));
}

void ProcessMonitor::begin_violation(ProcessError process_error, const RecordedMove& move,
                                     text::DiagnosticKind kind, std::string message) {
    if (std::exchange(process_error_, process_error) != process_error)
        add(make_finding(move, kind, std::move(message)));
}

void ProcessMonitor::end_program(rrs::TargetId next, const SourceLocation& location) {
    if (!machine_.process || !checks().end_with_process_on) return;
    ProcessFinding finding{.t_s = 0,
                           .location = location,
                           .kind = DiagnosticKind::end_with_process_on,
                           .message = fmt::format("the program ends with the {} on", process_)};
    ends_.push_back({next, std::move(finding)});
}

void ProcessMonitor::on_move(const RecordedMove& move) {
    if (!machine_.process) return;
    while (!ends_.empty() && ends_.front().next <= move.info.target_id) {
        ends_.front().finding.t_s = move.start_s;
        add(std::move(ends_.front().finding));
        ends_.pop_front();
    }
    if (machine_.process->kind == machine::ProcessKind::spindle) {
        check_spindle(move);
    } else if (move.info.kind == MoveKind::dwell) {
        check_dwell(move);
        if (move.info.process_on) idle_feed_.reset();
    } else {
        check_rapid(move);
        check_level(move);
    }
    last_end_ = move.end;
}

void ProcessMonitor::check_rapid(const RecordedMove& move) {
    if (move.info.kind != MoveKind::rapid || !move.info.process_on || !checks().rapid_with_process_on) {
        process_error_ = ProcessError::none;
        return;
    }
    begin_violation(ProcessError::rapid, move, DiagnosticKind::rapid_with_process_on,
                    fmt::format("a rapid move with the {} on", process_));
}

void ProcessMonitor::check_dwell(const RecordedMove& move) {
    const double standstill_s = move.end_s - move.start_s;
    if (!move.info.process_on || !checks().dwell_with_process_on || standstill_s <= checks().dwell_s) return;
    add(make_finding(move, DiagnosticKind::dwell_with_process_on,
                     fmt::format("a dwell of {:.10g} s with the {} on; the machine file allows {:.10g} s",
                                 standstill_s, process_, checks().dwell_s)));
}

void ProcessMonitor::check_spindle(const RecordedMove& move) {
    if (!is_feed(move.info.kind) || move.info.process_on || !checks().feed_with_process_off) {
        if (move.info.kind != MoveKind::dwell) process_error_ = ProcessError::none;
        return;
    }
    begin_violation(ProcessError::feed, move, DiagnosticKind::feed_with_spindle_off,
                    "a feed move with the spindle off");
}

bool ProcessMonitor::moves_in_xy(const RecordedMove& move) const {
    const auto moves = [&](std::optional<std::size_t> axis) {
        if (!axis) return false;
        const auto joint = static_cast<Eigen::Index>(*axis);
        return std::abs(move.end[joint] - last_end_[joint]) > kMinDistance_mm;
    };
    return moves(x_axis_) || moves(y_axis_) || (move.arc && std::abs(move.info.normal.z()) > kVerticalLimit);
}

/// Returns the height of a move in X and Y, if the machine's Z stays during it.
std::optional<std::int64_t> ProcessMonitor::level_um(const RecordedMove& move) const {
    if (!moves_in_xy(move)) return std::nullopt;
    if (!z_axis_) return 0;
    const auto joint = static_cast<Eigen::Index>(*z_axis_);
    const double height_mm = move.end[joint];
    if (std::abs(height_mm - last_end_[joint]) > 1 / kHeightStepsPerMm) return std::nullopt;
    return std::llround(height_mm * kHeightStepsPerMm);
}

// Checks a feed with the process off: it is an error at a height at which the program cuts, and no error
// above it. These heights are known when the program has ended; until then the feeds wait.
void ProcessMonitor::check_level(const RecordedMove& move) {
    if (!checks().feed_with_process_off) return;
    const std::optional<std::int64_t> level =
        is_feed(move.info.kind) ? level_um(move) : std::optional<std::int64_t>();
    if (move.info.process_on) {
        idle_feed_.reset();
        if (level && cut_levels_um_.size() < kMaxPlanes) cut_levels_um_.insert(*level);
        return;
    }
    const bool continues = is_feed(move.info.kind) && idle_feed_ &&
                           idle_feed_->switches == move.info.switches &&
                           (!level || *level == idle_feed_->level_um);
    if (continues) return;
    end_idle_feed();
    if (!level) return;
    std::string message =
        fmt::format("a feed move with the {} off, at a height at which the program cuts", process_);
    idle_feed_ = {*level, move.info.switches,
                  make_finding(move, DiagnosticKind::feed_with_process_off, std::move(message))};
}

void ProcessMonitor::end_idle_feed() {
    if (idle_feed_ && idle_feeds_.size() < kMaxPlanes) idle_feeds_.push_back(*std::move(idle_feed_));
    idle_feed_.reset();
}

void ProcessMonitor::end(double end_s) {
    for (ProgramEnd& at : ends_) {
        at.finding.t_s = end_s;
        add(std::move(at.finding));
    }
    ends_.clear();
    end_idle_feed();
    for (IdleFeed& feed : idle_feeds_) {
        // Rounding may put one height into two neighbouring micrometres.
        const auto plane = cut_levels_um_.lower_bound(feed.level_um - 1);
        if (plane != cut_levels_um_.end() && *plane <= feed.level_um + 1) add(std::move(feed.finding));
    }
    idle_feeds_.clear();
}

ProcessFindings ProcessMonitor::release() {
    std::stable_sort(findings_.list.begin(), findings_.list.end(),
                     [](const ProcessFinding& a, const ProcessFinding& b) { return a.t_s < b.t_s; });
    return std::move(findings_);
}

}  // namespace gsim::simulation

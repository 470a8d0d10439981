#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "calibrate/geometry/measured_tcp.h"
#include "calibrate/servo/servo_record.h"
#include "calibrate/times/motion_record.h"
#include "calibrate/times/recorded_run.h"
#include "machine/file/machine_file.h"
#include "tests/fuzz/checks.h"
#include "tests/fuzz/promises.h"

namespace gsim::fuzz {
namespace {

constexpr double kPeriod_s = 0.001;  // of recordings that have no times

Outcome refused_in_a_sentence(const std::string& error) {
    if (auto violation = fault_of_sentence(error)) return broken(*std::move(violation));
    return rejected();
}

bool all_finite(const std::vector<double>& values) {
    return std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
}

/// Each is finite, and more than the one before.
bool is_rising(const std::vector<double>& times_s) {
    return all_finite(times_s) &&
           std::adjacent_find(times_s.begin(), times_s.end(), std::greater_equal<>()) == times_s.end();
}

std::optional<std::string> fault_of_samples(const std::vector<calibrate::MotionSample>& samples) {
    std::vector<double> times_s;
    for (const calibrate::MotionSample& sample : samples) {
        if (!sample.at_mm.allFinite()) return fmt::format("no place at {} s", sample.t_s);
        times_s.push_back(sample.t_s);
    }
    if (!is_rising(times_s)) return "times that do not rise";
    return std::nullopt;
}

std::optional<std::string> fault_of_axis(const calibrate::AxisRecord& record) {
    if (!is_rising(record.t_s)) return fmt::format("{} has times that do not rise", record.letter);
    if (record.set_points.size() != record.t_s.size() || record.positions.size() != record.t_s.size())
        return fmt::format("{} lacks set points or places", record.letter);
    if (!all_finite(record.set_points) || !all_finite(record.positions))
        return fmt::format("{} is nowhere", record.letter);
    return std::nullopt;
}

/// Returns a machine on which TCPs may be measured.
const machine::Machine& measured_machine() {
    static const machine::Machine kMachine =
        machine::read_machine(machine::built_in_machine_toml(), "built-in machine").value();
    return kMachine;
}

bool is_same(const calibrate::MeasuredTcp& a, const calibrate::MeasuredTcp& b) {
    constexpr double kNear = 1e-6;  // as they are written
    if (a.readings.size() != b.readings.size() || a.has_orientation != b.has_orientation) return false;
    for (std::size_t axis = 0; axis < a.readings.size(); ++axis) {
        if (std::abs(a.readings[axis] - b.readings[axis]) > kNear * (1 + std::abs(a.readings[axis])))
            return false;
    }
    return (a.tcp.translation() - b.tcp.translation()).norm() <= kNear * (1 + a.tcp.translation().norm());
}

std::optional<std::string> fault_of_tips(const calibrate::TcpList& list) {
    const machine::Machine& machine = measured_machine();
    for (const calibrate::MeasuredTcp& tcp : list.tcps) {
        if (tcp.readings.size() != machine.axes.size()) return "a tip without readings of all axes";
        if (!all_finite(tcp.readings) || !tcp.tcp.matrix().allFinite()) return "a tip that is nowhere";
        const auto repeated =
            calibrate::read_tcps(calibrate::print_tcps({tcp}, machine, tcp.has_orientation, true), machine);
        if (!repeated) return "what was written is refused: " + repeated.error().message;
        if (repeated->tcps.size() != 1 || !is_same(tcp, repeated->tcps.front()))
            return "a tip is another one when it is written";
    }
    return std::nullopt;
}

}  // namespace

Outcome check_motion_record(std::string_view text) {
    for (const double period_s : {0.0, kPeriod_s}) {
        const calibrate::RecordFormat record_format{.period_s = period_s, .columns = "x-yz"};
        const auto samples = calibrate::read_motion_record(text, record_format);
        if (!samples) {
            if (auto violation = fault_of_sentence(samples.error().message))
                return broken(*std::move(violation));
            continue;
        }
        if (auto violation = fault_of_samples(*samples)) return broken(*std::move(violation));
        calibrate::RecordedRun run;
        const auto added = calibrate::add_record(text, record_format, run);
        if (!added) return refused_in_a_sentence(added.error().message);
        if (!(run.time_s > 0) || !std::isfinite(run.time_s))
            return broken(fmt::format("a motion of {} s", run.time_s));
        return accepted();
    }
    return rejected();
}

Outcome check_servo_record(std::string_view text) {
    for (const double period_s : {0.0, kPeriod_s}) {
        const auto records = calibrate::read_servo_record(text, {.period_s = period_s, .columns = "XxYy-"});
        if (!records) {
            if (auto violation = fault_of_sentence(records.error().message))
                return broken(*std::move(violation));
            continue;
        }
        for (const calibrate::AxisRecord& record : *records) {
            if (auto violation = fault_of_axis(record)) return broken(*std::move(violation));
        }
        return accepted();
    }
    return rejected();
}

Outcome check_run_list(std::string_view text) {
    const auto runs = calibrate::read_recorded_runs(text, "folder");
    if (!runs) return refused_in_a_sentence(runs.error().message);
    for (const calibrate::RecordedRun& run : *runs) {
        const bool has_time = run.time_s > 0 && std::isfinite(run.time_s);
        if (!has_time && run.record.empty()) return broken(run.program + " has neither time nor recording");
        if (run.program.empty() || run.program == "folder/") return broken("a run without a program");
    }
    return accepted();
}

Outcome check_tip_list(std::string_view text) {
    const auto list = calibrate::read_tcps(text, measured_machine());
    if (!list) return refused_in_a_sentence(list.error().message);
    if (auto violation = fault_of_tips(*list)) return broken(*std::move(violation));
    return accepted();
}

}  // namespace gsim::fuzz

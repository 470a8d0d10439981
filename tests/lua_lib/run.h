#pragma once

#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "machine/data/machine_data.h"
#include "runtime/outputs/run_output.h"
#include "runtime/report/report.h"
#include "runtime/script/engine/engine.h"
#include "runtime/simulator/probe.h"

namespace gsim::script {

machine::Machine built_in_machine();

/// Conditions of a run; by default: the built-in machine, no stored values, no switch on.
struct Conditions {
    machine::Machine machine = built_in_machine();
    Engine::Options options;
    /// Past a range or in a zone the run ends there, unless a test wants it to go on.
    simulation::RunLimits limits{.stop_at_first = true};
    simulation::ProbeSurface probe;
    motion::OverrideSchedule overrides;
};

/// The same with two tools in the table: 10 and 25 mm long, 6 and 4 mm in diameter.
Conditions with_tools(Conditions setup = {});

/// Result of a run.
struct Outcome {
    machine::Machine machine;
    std::string lua;
    std::vector<simulation::RecordedMove> moves;
    std::vector<motion::Segment> segments;
    simulation::Report report;

    bool completed() const { return report.status == simulation::RunStatus::completed; }
    std::string message() const { return report.alarm ? report.alarm->message : std::string(); }
    std::uint32_t line() const { return report.alarm ? report.alarm->location.line : 0; }
    /// Value of an axis (mm or deg) at the end of move `n`, from 0.
    double to(std::size_t n, char letter) const;
    /// Returns the machine's position at the end: X, Y, Z in mm, B and C in deg.
    std::array<double, 5> end() const;
    double seconds(std::size_t n) const { return moves.at(n).end_s - moves.at(n).start_s; }
    /// The kinds of all events in their order, with one blank between them.
    std::string events() const;
};

/// Translates a program, which must have no errors, and runs it, both at once and function by function, with
/// the same result. Its file is "part.nc".
Outcome run(std::string_view gcode, Conditions setup = {});
/// Runs a script; its file is "part.lua".
Outcome run_lua(std::string_view lua, Conditions setup = {});
/// Runs any script.
Outcome run_script(Script script, Conditions setup);
/// The diagnostics of a program that must not translate.
std::string diagnostics_text(std::string_view gcode, std::string_view dialect = "ab9");

/// Returns the min time from standstill to standstill, from first principles.
double trapezoid_s(double length, double speed, double acceleration);

inline constexpr double kFeed_mm_s = 254;
inline constexpr double kAcceleration_mm_s2 = 490.33;
inline constexpr double kTurn_deg_s = 90;
inline constexpr double kTurn_deg_s2 = 20;

/// The run ends without an alarm at these axis values, to 1e-6 mm or deg.
void expect_end(const Outcome& run, double x, double y, double z, double b = 0, double c = 0);
/// The run ends with an alarm in that line; each text is in its message, or is its code: "[word-value]".
void expect_alarm(const Outcome& run, std::uint32_t line, const std::vector<std::string>& texts);
/// The same in any line.
void expect_alarm(const Outcome& run, const std::string& text);
/// A limit of the run ends it, and that text is in the message.
void expect_stopped(const Outcome& run, const std::string& text);

}  // namespace gsim::script

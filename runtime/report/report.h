#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/text/diagnostic.h"
#include "controller/services/types.h"
#include "motion/planner/override_schedule.h"
#include "runtime/report/effort_report.h"
#include "runtime/report/following_report.h"
#include "runtime/simulator/move.h"

namespace gsim::simulation {

enum class RunStatus {
#define GSIM_RUN_STATUS(name, number, constant) name = (number),
#include "base/kinds/run_status.def"
};
std::string_view name(RunStatus status);

/// Call of a program that had not ended.
struct OpenCall {
    std::string program;           ///< "O2"
    SourceLocation location = {};  ///< Location of the call.
};

/// Reason why a run did not complete, as a message, and its location.
struct Alarm {
    text::DiagnosticKind kind = text::DiagnosticKind::script;
    std::string message;
    SourceLocation location = {};
    std::vector<OpenCall> calls = {};  ///< From the innermost to the first.
    char axis = 0;                     ///< Letter, if one axis is the cause.
    std::optional<double> value;       ///< Value of that axis (mm or deg).
    std::optional<double> limit;       ///< That it passed (mm or deg).
};

/// Max number of them that a report lists.
inline constexpr std::size_t kMaxViolations = 1000;

/// Move past the range of an axis, or a tool position that a zone does not allow. The run continues.
struct Violation {
    double t_s = 0;  ///< For an axis: start of the move; for a zone: when the tool passes the wall.
    SourceLocation location = {};
    std::vector<OpenCall> calls = {};  ///< From the innermost to the first.
    std::string zone = {};             ///< Its name; empty if the range of an axis is passed.
    bool forbidden_zone = false;       ///< The tool is in it, not out of it.
    std::string message = {};          ///< A message without its full stop.
    char axis = 'X';                   ///< Letter.
    bool rotary = false;               ///< Values are in deg, else in mm.
    double value = 0;                  ///< Farthest position of the axis; for a zone: the tool's end.
    double limit = 0;                  ///< That it passes: the end of a range, or a wall.
    std::string offset = {};           ///< Code of the active work offset: "G54"; empty if unknown.

    double amount() const { return value < limit ? limit - value : value - limit; }
};

/// Shift of a work offset along a linear axis.
struct OffsetShift {
    std::string offset;  ///< "G54"
    char axis = 'X';
    double shift_mm = 0;
};

struct Violations {
    std::vector<Violation> list;  ///< The first ones by time, kMaxViolations at most.
    std::uint64_t count = 0;      ///< Total count, also of those that are not listed.
    /// Shifts that bring back everything outside; what they move outside is unknown.
    std::vector<OffsetShift> shifts;
    /// All of these together, if known to bring the full program within limits and zones. Otherwise empty.
    std::vector<OffsetShift> suggested_fix;

    /// Returns the time from which times are not those of a machine, which would have stopped; nullopt
    /// without violations.
    std::optional<double> valid_until_s() const {
        return list.empty() ? std::nullopt : std::optional(list.front().t_s);
    }
};

/// Returns "G54 X +12.5 mm would bring the whole program within the limits"; empty if no suggested fix is
/// known.
std::string suggested_fix_text(const Violations& violations);

/// Max number of them that a report lists.
inline constexpr std::size_t kMaxFindings = 1000;

/// Finding about an action that a program should not do on its machine, though it can ([checks] of the
/// machine file).
struct ProcessFinding {
    double t_s = 0;
    SourceLocation location = {};
    text::DiagnosticKind kind = text::DiagnosticKind::rapid_with_process_on;
    std::string message;  ///< A message without its full stop.
};

struct ProcessFindings {
    std::vector<ProcessFinding> list;  ///< By time, kMaxFindings at most.
    std::uint64_t count = 0;           ///< Total count.
};

struct Event {
    double t_s = 0;
    SourceLocation location = {};
    std::string kind;    ///< process_on, jet_off, abrasive_on, abrasive_off, stop, optional_stop, tool, ...
    std::string detail;  ///< Free text for people; may be empty.
};

struct AxisBounds {
    char letter = 'X';
    bool rotary = false;
    double min = 0, max = 0;              ///< Reached, from the start position on (mm or deg).
    double limit_min = 0, limit_max = 0;  ///< Machine limits.
};

/// Max distance of the TCP from the programmed path on the part.
struct Deviation {
    double deviation_mm = 0;
    SourceLocation location = {};  ///< Location of the move there; at a corner, the next one.
};

/// Deviations of the controller from the programmed path: PathDeviationMonitor.
struct Blends {
    bool measured = true;     ///< False for a controller module.
    std::uint64_t count = 0;  ///< Ends of moves that the TCP does not pass.
    Deviation feed = {};      ///< In corners of feed moves,
    Deviation rapid = {};     ///< and between rapid moves.

    const Deviation& max() const { return rapid.deviation_mm > feed.deviation_mm ? rapid : feed; }
};

struct SlowBlock {
    SourceLocation location = {};
    MoveKind kind = MoveKind::linear;
    double duration_s = 0;
    double length_mm = 0;
    std::string limited_by = {};  ///< Cause that kept it from being faster (describe()); empty in a dwell.
};

/// Time for which one cause kept the machine from being faster.
struct LimitTime {
    std::string limited_by;  ///< As describe() names it, or "dwell".
    double time_s = 0;
};

/// Reason why the run took as long as it did.
struct Explanation {
    std::vector<LimitTime> time_by_limit;  ///< Longest time first; together the cycle time.
    /// Lower bound of the time that any controller needs for the same path (PathBound); nullopt for a motion
    /// that is known by samples.
    std::optional<double> lower_bound_s = 0;
};

/// Passes of a main program that leads back to its start (M99), or by its last block to a block of it:
/// without end on the machine.
struct Passes {
    std::uint64_t count = 0;               ///< That were run.
    SourceLocation location = {};          ///< Location of the jump back.
    std::optional<std::int64_t> to_block;  ///< Its number; nullopt: the start.
};

/// Overrides that the operator turned, and how long the machine moved without obeying them: because the
/// program had locked an override, or by the kind of the move.
struct OverrideReport {
    std::vector<motion::OverrideChange> changes;
    double feed_locked_s = 0;
    double rapid_locked_s = 0;
    double spindle_locked_s = 0;  ///< For moves with a feed that follows the spindle.
};

/// Start of contact between two bodies of the cell.
struct Collision {
    double t_s = 0;
    SourceLocation location = {};
    std::string first, second;            ///< Names of the bodies.
    std::array<double, 3> point_mm = {};  ///< Position in the world.
    bool penetrating = false;             ///< Else they only touch.
    rrs::JointPos joints = {};            ///< Machine joints then, mm or rad.
};

/// Smallest distance of a block, if it is below what the cell requires.
struct BlockClearance {
    SourceLocation location = {};
    double clearance_mm = 0;
    std::string first, second;
    std::array<double, 3> point_mm = {};  ///< On the second body, in the world.
};

/// Bodies for which each pair that can meet was checked, on its complete path.
struct CheckedBodies {
    std::size_t machine_shapes = 0;  ///< Shapes of the machine and of what it carries.
    std::size_t jets = 0;
    std::size_t objects = 0;
    std::size_t pairs = 0;
    std::size_t allowed_pairs = 0;  ///< Pairs that were left out, as machine and cell say so.
    std::size_t replaced = 0;       ///< Shapes of the machine file that the cell replaces by others.
    std::size_t robot_pairs = 0;    ///< Pairs of its own bodies and those of other robots.
};

/// Findings of a run in its cell.
struct CellFindings {
    std::string name;
    double clearance_mm = 0;  ///< That is asked for.
    CheckedBodies checked_bodies = {};
    std::vector<Collision> collisions;
    std::vector<BlockClearance> clearances;
    std::uint64_t dropped = 0;  ///< Entries past the max number that a report lists.
};

/// Result of a process of the run.
struct ProcessSummary {
    std::string name;
    std::string robot;        ///< Robot that it moved last; empty if it moved none.
    std::string state;        ///< "done", "waiting" or, if the run ended before it did, "stopped".
    bool background = false;  ///< The run did not wait for its end.
    double start_s = 0;
    double end_s = 0;
    double idle_s = 0;  ///< In which its robots waited for others.
};

/// Change of a signal by a process.
struct SignalChange {
    double t_s = 0;
    SourceLocation location = {};
    std::string process;
    std::string signal;
    std::string value;  ///< As scripts write it.
};

/// Use of a shared zone by a process, or its wait for the zone.
struct ZoneUse {
    std::string zone;
    std::string process;
    SourceLocation location = {};  ///< Location of its request for the zone.
    double requested_s = 0;        ///< When it did.
    std::optional<double> from_s;  ///< Start of its use of the zone; nullopt: it never had it.
    std::optional<double> to_s;    ///< Nullopt: to the end of the run.
};

/// Interval that contains the time of a run with a probability of 95 %, as far as the parameters of the
/// machine are known.
struct TimeInterval {
    double min_s = 0;
    double max_s = 0;
};

/// The program and the machine of a run.
struct ReportSource {
    std::string program;
    std::string machine;
    std::string controller;          ///< Model that the machine file names; empty if a module plans.
    std::string process = "jet";     ///< Process of the machine: "jet", "plasma", "laser", "spindle".
    std::vector<std::string> files;  ///< Names that SourceLocation::file indexes.
};

/// Parts of the cycle time, and its interval.
struct ReportTimes {
    std::optional<TimeInterval>
        interval;  ///< For the cycle time, if the machine file says how it was fitted.
    double rapid_s = 0, feed_s = 0, dwell_s = 0;
    double words_s = 0;  ///< The part of dwell_s that words took by [times] of the machine file.
};

/// Distances of the TCP.
struct ReportDistances {
    double rapid_mm = 0, feed_mm = 0, process_on_mm = 0;
};

struct ReportCounts {
    std::uint64_t blocks = 0;
    std::uint64_t moves = 0;
};

struct ReportMessages {
    std::vector<std::string> warnings;
    std::vector<text::Diagnostic> diagnostics;  ///< For the program's text.
};

/// Findings about motors and servo loops.
struct DriveReports {
    std::optional<EffortReport> efforts;       ///< If the machine file gives masses.
    std::optional<FollowingReport> following;  ///< If it gives servo loops.
};

/// Work of several processes.
struct ConcurrencyReport {
    std::vector<ProcessSummary> processes;  ///< Empty if only the program ran.
    std::vector<SignalChange> signals;
    std::vector<ZoneUse> zone_uses;  ///< Uses of shared zones, in the order of their requests.
};

/// Complete result of a run; units are in the names, and in the JSON as well.
struct Report {
    ReportSource source;
    RunStatus status = RunStatus::completed;
    std::optional<Alarm> alarm;  ///< Also why a run was stopped.
    Violations violations;
    ProcessFindings findings;
    double cycle_time_s = 0;
    ReportTimes times;
    ReportDistances distances;
    ReportCounts counts;
    Blends blends;
    std::vector<AxisBounds> bounds;
    std::vector<Event> events;
    ReportMessages messages;
    std::optional<Passes> passes;
    std::optional<OverrideReport> overrides;  ///< If the operator turned one.
    std::vector<SlowBlock> slowest;           ///< At most ten, longest first.
    std::optional<Explanation> explanation;
    DriveReports drives;
    std::optional<CellFindings> cell;
    ConcurrencyReport concurrency;
};

/// Returns the report as the JSON of the design (docs/report.md); keys in a fixed order, doubles in shortest
/// form.
std::string to_json(const Report& report);

/// "1 of the main program, which leads back to its start; --passes runs more"
std::string to_text(const Passes& passes);

/// Returns the report as a compact table for people.
std::string to_text(const Report& report);

}  // namespace gsim::simulation

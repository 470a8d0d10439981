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

/// A call of a program that had not ended.
struct OpenCall {
    std::string program;  ///< "O2"
    Place place = {};     ///< Of the call.
};

/// Why a run did not complete, as a sentence, and where.
struct Alarm {
    text::DiagnosticKind kind = text::DiagnosticKind::script;
    std::string message;
    Place place = {};
    std::vector<OpenCall> calls = {};  ///< From the innermost to the first.
    char axis = 0;                     ///< Letter, where one axis is to blame.
    std::optional<double> value;       ///< Of that axis (mm or deg).
    std::optional<double> limit;       ///< That it passed (mm or deg).
};

/// What a report lists of them, at most.
inline constexpr std::size_t kMostViolations = 1000;

/// A move takes an axis past its range, or the tool begins to be where a zone does not allow it. The run goes
/// on behind it.
struct Violation {
    double t_s = 0;  ///< Of an axis: when the move begins; of a zone: when the tool passes the wall.
    Place place = {};
    std::vector<OpenCall> calls = {};  ///< From the innermost to the first.
    std::string zone = {};             ///< Its name; empty where the range of an axis is passed.
    bool forbidden_zone = false;       ///< The tool is in it, not out of it.
    std::string message = {};          ///< A sentence without its end.
    char axis = 'X';                   ///< Letter.
    bool rotary = false;               ///< Values are in deg, else in mm.
    double value = 0;                  ///< The farthest that the axis goes; of a zone: the tool's end.
    double limit = 0;                  ///< That it passes: the end of a range, or a wall.
    std::string offset = {};  ///< Code of the work offset in force: "G54"; empty where none is known.

    double amount() const { return value < limit ? limit - value : value - limit; }
};

/// A shift of a work offset along a linear axis.
struct OffsetShift {
    std::string offset;  ///< "G54"
    char axis = 'X';
    double shift_mm = 0;
};

struct Violations {
    std::vector<Violation> list;  ///< The first ones by time, kMostViolations at most.
    std::uint64_t count = 0;      ///< Of all, those that are not listed as well.
    /// What brings back all that is out; what this takes out is not known.
    std::vector<OffsetShift> shifts;
    /// Of these, all together: known to bring the whole program within limits and zones. Else none.
    std::vector<OffsetShift> remedy;

    /// From here on times are not those of a machine, which would have stopped; none without violations.
    std::optional<double> valid_until_s() const {
        return list.empty() ? std::nullopt : std::optional(list.front().t_s);
    }
};

/// "G54 X +12.5 mm would bring the whole program within the limits"; empty where no remedy is known.
std::string remedy_text(const Violations& violations);

/// What a report lists of them, at most.
inline constexpr std::size_t kMostFindings = 1000;

/// What a program should not do on its machine, though it can ([checks] of the machine file).
struct ProcessFinding {
    double t_s = 0;
    Place place = {};
    text::DiagnosticKind kind = text::DiagnosticKind::rapid_with_process_on;
    std::string message;  ///< A sentence without its end.
};

struct ProcessFindings {
    std::vector<ProcessFinding> list;  ///< By time, kMostFindings at most.
    std::uint64_t count = 0;           ///< Of all.
};

struct Event {
    double t_s = 0;
    Place place = {};
    std::string kind;    ///< jet_on, jet_off, abrasive_on, abrasive_off, stop, optional_stop, tool, ...
    std::string detail;  ///< Free text for people; may be empty.
};

struct AxisBounds {
    char letter = 'X';
    bool rotary = false;
    double min = 0, max = 0;              ///< Reached, from the start position on (mm or deg).
    double limit_min = 0, limit_max = 0;  ///< Of the machine.
};

/// The farthest that the tip leaves the programmed way on the part.
struct Deviation {
    double deviation_mm = 0;
    Place place = {};  ///< Of the move there; the one behind a corner.
};

/// Where the controller leaves the programmed way: WayDeviation.
struct Blends {
    bool measured = true;     ///< A controller module does not tell.
    std::uint64_t count = 0;  ///< Ends of moves that the tip does not pass.
    Deviation feed = {};      ///< In corners of feed moves,
    Deviation rapid = {};     ///< and between rapid moves.

    const Deviation& greatest() const { return rapid.deviation_mm > feed.deviation_mm ? rapid : feed; }
};

struct SlowBlock {
    Place place = {};
    MoveKind kind = MoveKind::linear;
    double duration_s = 0;
    double length_mm = 0;
    std::string limited_by = {};  ///< What kept it from being faster (describe()); empty in a dwell.
};

/// How long something was what kept the machine from being faster.
struct LimitTime {
    std::string limited_by;  ///< As describe() names it, or "dwell".
    double time_s = 0;
};

/// Why the run took as long as it did.
struct Explanation {
    std::vector<LimitTime> time_by_limit;  ///< The most time first; together the cycle time.
    /// In which no controller could go the same path (PathBound); none of a motion that is known by samples.
    std::optional<double> lower_bound_s = 0;
};

/// The main program leads back to its start (M99), or by its last block to a block of it: for ever on the
/// machine.
struct Passes {
    std::uint64_t count = 0;               ///< That were run.
    Place place = {};                      ///< Of what leads back.
    std::optional<std::int64_t> to_block;  ///< Its number; none: the start.
};

/// What the operator turned, and how long the machine moved that was deaf to it: because the program had
/// locked an override, or by the kind of the move.
struct OverrideReport {
    std::vector<motion::OverrideChange> changes;
    double feed_locked_s = 0;
    double rapid_locked_s = 0;
    double spindle_locked_s = 0;  ///< Of moves whose feed follows the spindle.
};

/// Two bodies of the cell begin to touch.
struct Collision {
    double t_s = 0;
    Place place = {};
    std::string first, second;            ///< Names of the bodies.
    std::array<double, 3> point_mm = {};  ///< Where, in the world.
    bool penetrating = false;             ///< Else they only touch.
    rrs::JointPos joints = {};            ///< Of the machine then, mm or rad.
};

/// The smallest distance of a block, where it is below what the cell asks for.
struct BlockClearance {
    Place place = {};
    double clearance_mm = 0;
    std::string first, second;
    std::array<double, 3> point_mm = {};  ///< On the second body, in the world.
};

/// The bodies of which each pair that can meet was looked at, on all of its way.
struct LookedAt {
    std::size_t of_machine = 0;  ///< Shapes of the machine and of what it carries.
    std::size_t jets = 0;
    std::size_t objects = 0;
    std::size_t pairs = 0;
    std::size_t may_touch = 0;    ///< Pairs that were left out, as machine and cell say so.
    std::size_t replaced = 0;     ///< Shapes of the machine file in whose place the cell has others.
    std::size_t with_robots = 0;  ///< Pairs of its own bodies and those of other robots.
};

/// What a run did in its cell.
struct CellFindings {
    std::string name;
    double clearance_mm = 0;  ///< That is asked for.
    LookedAt looked_at = {};
    std::vector<Collision> collisions;
    std::vector<BlockClearance> clearances;
    std::uint64_t dropped = 0;  ///< Entries past the most that a report lists.
};

/// What became of a process of the run.
struct ProcessSummary {
    std::string name;
    std::string robot;        ///< That it moved last; empty where it moved none.
    std::string state;        ///< "done", "waiting" or, where the run ended before it did, "stopped".
    bool background = false;  ///< The run did not wait for its end.
    double start_s = 0;
    double end_s = 0;
    double idle_s = 0;  ///< In which its robots waited for others.
};

/// A signal that a process has changed.
struct SignalChange {
    double t_s = 0;
    Place place = {};
    std::string process;
    std::string signal;
    std::string value;  ///< As scripts write it.
};

/// A process had a shared zone, or waited for it.
struct ZoneUse {
    std::string zone;
    std::string process;
    Place place = {};              ///< Where it asked for the zone.
    double asked_s = 0;            ///< When it did.
    std::optional<double> from_s;  ///< From then on it had the zone; none: it never did.
    std::optional<double> to_s;    ///< None: to the end of the run.
};

/// The whole result of a run; units are in the names, and in the JSON as well.
/// Between these the time of a run is with a probability of 95 %, as far as the figures of the machine are
/// known.
struct TimeInterval {
    double least_s = 0;
    double most_s = 0;
};

struct Report {
    std::string program;
    std::string machine;
    std::string controller;  ///< The model that its machine file names; empty where a module plans.
    RunStatus status = RunStatus::completed;
    std::optional<Alarm> alarm;  ///< Also why a run was stopped.
    Violations violations;
    ProcessFindings findings;
    std::string process = "jet";  ///< What the machine works with: "jet", "plasma", "laser", "spindle".
    double cycle_time_s = 0;
    std::optional<TimeInterval>
        interval;  ///< Of cycle_time_s, where the machine file tells how it was fitted.
    double rapid_s = 0, feed_s = 0, dwell_s = 0;
    double words_s = 0;  ///< The part of dwell_s that words took by [times] of the machine file.
    double rapid_mm = 0, feed_mm = 0, jet_on_mm = 0;
    std::uint64_t blocks = 0;
    std::uint64_t moves = 0;
    Blends blends;
    std::vector<AxisBounds> bounds;
    std::vector<Event> events;
    std::vector<std::string> warnings;
    std::vector<text::Diagnostic> diagnostics;  ///< Of the program's text.
    std::optional<Passes> passes;
    std::optional<OverrideReport> overrides;  ///< Where the operator turned one.
    std::vector<SlowBlock> slowest;           ///< At most ten, longest first.
    std::optional<Explanation> explanation;
    std::optional<EffortReport> efforts;       ///< Where the machine file tells of masses.
    std::optional<FollowingReport> following;  ///< Where it tells of servo loops.
    std::optional<CellFindings> cell;
    std::vector<ProcessSummary> processes;  ///< None where there was but the program.
    std::vector<SignalChange> signals;
    std::vector<ZoneUse> zone_uses;  ///< Of shared zones, in the order in which they were asked for.
    std::vector<std::string> files;  ///< Names that Place::file indexes.
};

/// The report as the JSON of the design (docs/report.md); keys in a fixed order, doubles in shortest form.
std::string to_json(const Report& report);

/// "1 of the main program, which leads back to its start; --passes runs more"
std::string to_text(const Passes& passes);

/// The report as a compact table for people.
std::string to_text(const Report& report);

}  // namespace gsim::simulation

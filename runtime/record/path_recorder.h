#pragma once

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "runtime/path/path.h"
#include "runtime/record/path_builder.h"
#include "runtime/record/tool_place.h"
#include "runtime/simulation/program_observer.h"

namespace gsim::record {

/// Makes a path of what a program asks of a machine: loops are unrolled, called programs become sub-paths.
/// Positions are those of the tip in the machine's work frame, without the program's own offsets, which are
/// in them; rotary axes stand as they stand. docs/report.md tells what becomes of what.
class PathRecorder final : public simulation::ProgramObserver {
  public:
    /// `machine` must outlive this.
    explicit PathRecorder(const machine::Machine& machine) : place_(machine) {}

    void line(const simulation::AxisVector& from, const simulation::LineMove& move,
              bool rotary_alone) override;
    void arc(const simulation::AxisVector& from, const simulation::ArcMove& move) override;
    void arc(const simulation::AxisVector& from, const simulation::ViaMove& move) override;
    void dwell(const simulation::AxisVector& at, double seconds) override;
    void event(const simulation::AxisVector& at, const simulation::Event& event) override;
    void enter_program(const std::string& name) override;
    void leave_program() override;
    void service_motion() override;

    /// What the path does not show as it was, one sentence each.
    const std::set<std::string>& notes() const { return notes_; }
    /// The path, once, behind the last move; `name` is the program's. The error is a sentence.
    tl::expected<path::Program, std::string> finish(const std::string& name);

  private:
    /// Where the axes are after a share, 0 to 1, of a move.
    using Way = std::function<simulation::AxisVector(double share)>;
    /// What has been written in the path that is open, which is in force.
    struct InForce {
        std::optional<double> feed_mm_min, feed_deg_min;
        std::optional<path::Orientation> orientation;
    };

    static constexpr double kTolerance_mm = 0.0005;  ///< Of lines in place of another motion of the tip.

    bool is_full();
    path::Point point_at(const simulation::AxisVector& axes, path::MotionType motion);
    void set_feed(path::Point& point, const simulation::Feed& feed, bool rotary_alone);
    void start_from(const simulation::AxisVector& from);
    void hold(const simulation::AxisVector& at);
    void line_or_lines(const simulation::AxisVector& from, const simulation::LineMove& move,
                       bool rotary_alone);
    bool arcs(const simulation::AxisVector& from, const simulation::ArcMove& move, const Way& way);
    bool is_straight(const Way& way, double from, double to) const;
    bool is_on(const path::Vector& start_mm, const path::Point& arc, const Way& way, double from,
               double to) const;
    void lines(const Way& way, double from, double to, const simulation::Feed& feed, double whole_s,
               int halvings);
    Way way_of(const simulation::AxisVector& from, const simulation::ArcMove& move) const;

    ToolPlace place_;
    PathBuilder builder_;
    InForce in_force_;
    std::set<std::string> notes_;
    std::string fault_;
};

}  // namespace gsim::record

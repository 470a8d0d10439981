#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "runtime/record/path_builder.h"
#include "runtime/record/tool_position.h"
#include "runtime/simulator/program_observer.h"
#include "toolpath/model/path.h"

namespace gsim::record {

/// Recorder of a path from a program's requests to a machine: loops are unrolled, called programs become
/// sub-paths. Positions are those of the TCP in the machine's work frame, and include the program's own
/// offsets; rotary axes keep their values. docs/report.md lists what becomes of what.
class PathRecorder final : public simulation::ProgramObserver {
  public:
    /// `machine` must outlive this.
    explicit PathRecorder(const machine::Machine& machine) : tool_position_(machine) {}

    std::size_t retained_bytes() const override { return builder_.retained_bytes(); }
    void line(const simulation::AxisVector& from, const simulation::LineMove& move,
              bool is_rotary_only) override;
    void arc(const simulation::AxisVector& from, const simulation::ArcMove& move) override;
    void arc(const simulation::AxisVector& from, const simulation::ViaMove& move) override;
    void dwell(const simulation::AxisVector& at, double seconds) override;
    void event(const simulation::AxisVector& at, const simulation::Event& event, bool at_standstill) override;
    void enter_program(const std::string& name) override;
    void leave_program() override;
    void on_unrecordable_motion(std::string_view reason) override;
    void standstill(const simulation::AxisVector& at) override;
    void spindle_speed(const simulation::AxisVector& at, double rev_min) override;
    void path_mode(const simulation::AxisVector& at, const simulation::PathModeSettings& settings) override;
    void exact_stop_once(const simulation::AxisVector& at) override;
    void ramps(const simulation::AxisVector& at, rrs::RampMode mode) override;
    void ramp_limit(const simulation::AxisVector& at, rrs::RampLimit limit, const machine::Axis& axis,
                    double value) override;
    void no_ramp_limits(const simulation::AxisVector& at) override;
    void work_offset(const simulation::WorkOffset& offset) override;
    void tool_offset(const Eigen::Vector3d& offset_mm) override;

    /// Returns what the path does not show as it was, one message each.
    const std::set<std::string>& notes() const { return notes_; }
    /// Returns the path, once, after the last move; `name` is the program's.
    Result<path::Program> finish(const std::string& name);

  private:
    /// Function that gives the axis values at a share, 0 to 1, of a move.
    using AxisPath = std::function<simulation::AxisVector(double share)>;
    /// Active values that have been written in the open path.
    struct ActiveSettings {
        std::optional<double> feed_mm_min, feed_mm_rev, feed_deg_min;
        std::optional<path::Orientation> orientation;
        std::string work_offset;
    };

    static constexpr double kDegPerMm = 1e-6;  ///< A TCP that moves less than this share of a turn is still.
    static constexpr double kTolerance_mm = 0.0005;  ///< For lines in place of another motion of the TCP.

    bool is_full();
    void begin(const simulation::AxisVector& at);
    void moves(const simulation::AxisVector& from);
    void record_standstill(const simulation::AxisVector& at);
    void add_action(const simulation::AxisVector& at, std::string action);
    path::Point point_at(const simulation::AxisVector& axes, path::MotionType motion);
    void set_feed(path::Point& point, const simulation::Feed& feed, bool is_rotary_only);
    void depend_on_start(const simulation::AxisVector& from);
    void add_action_point(const simulation::AxisVector& at);
    void record_line(const simulation::AxisVector& from, const simulation::LineMove& move,
                     bool is_rotary_only);
    bool arcs(const simulation::AxisVector& from, const simulation::ArcMove& move, const AxisPath& axis_path);
    bool is_straight(const AxisPath& axis_path, double from, double to) const;
    bool is_on(const path::Vector& start_mm, const path::Point& arc, const AxisPath& axis_path, double from,
               double to) const;
    void lines(const AxisPath& axis_path, double from, double to, const simulation::Feed& feed,
               double total_s, int halvings);
    AxisPath arc_path(const simulation::AxisVector& from, const simulation::ArcMove& move) const;

    ToolPosition tool_position_;
    PathBuilder builder_;
    ActiveSettings active_settings_;
    std::string work_offset_;  // as the program has selected it
    std::map<std::string, path::WorkOffset, std::less<>> work_offsets_;
    simulation::PathModeSettings path_mode_settings_{rrs::PathMode::continuous, 0,
                                                     0};  // in which programs begin
    std::optional<double> spindle_rev_min_;
    bool moved_since_standstill_ = false;  // since the machine has last waited
    bool standstill_pending_ = false;      // before what follows, though no dwell or switch says so
    simulation::AxisVector standstill_position_;
    std::set<std::string> notes_;
    std::string error_;
};

}  // namespace gsim::record

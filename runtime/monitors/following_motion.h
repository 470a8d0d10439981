#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <vector>

#include "motion/dynamics/servo_motion.h"
#include "runtime/monitors/following_setup.h"
#include "runtime/monitors/programmed_path.h"
#include "runtime/monitors/set_point_path.h"
#include "runtime/monitors/workpiece_tcp.h"
#include "runtime/simulator/move.h"

namespace gsim::simulation {

/// Returns true if an axis of the machine specifies its servo loop: then following errors are computed for
/// all.
bool has_servos(const machine::Machine& machine);
/// Returns the loops of its joints: missing gains of axes are the controller's, and an axis without either
/// follows at once.
std::vector<dynamics::ServoLoop> servo_loops(const machine::Machine& machine);

/// Instant of the real motion.
struct FollowingInstant {
    double t_s = 0;
    rrs::JointPos errors;    ///< Set point minus position, mm or rad.
    Eigen::Vector3d tcp_mm;  ///< Real TCP on the part.
    /// Distance of that from the path of its set points; nullopt from a tool change, which turns about the
    /// part, until the axes are in their bands.
    std::optional<double> contour_error_mm;
    /// The same from the programmed path, if that is known. It may be unknown while something else moves the
    /// axes at the same time (a belt, an axis group). This lasts until they are in their bands again.
    std::optional<double> program_deviation_mm;
};

/// Tracker of the axes and the TCP of a machine along its segments.
class FollowingMotion {
  public:
    /// Callback with the start and the end of each step.
    using StepHandler = std::function<void(double from_s, double to_s)>;

    explicit FollowingMotion(const FollowingSetup& setup, double step_s = dynamics::ServoMotion::kStep_s);

    /// Adds, before all else, the distance of the TCP from this path to each instant. The path outlives this.
    void set_programmed_path(ProgrammedPath& program) { program_ = &program; }
    void begin(const rrs::JointPos& start);
    /// As in ServoMotion.
    void enter(const motion::Segment& segment, const MoveInfo& info, const StepHandler& on_step = {});
    void go_to(double t_s, const StepHandler& on_step = {});
    void leave(const StepHandler& on_step = {});
    double now_s() const { return servos_.now_s(); }

    /// Returns the state at an instant of the last three steps.
    FollowingInstant at(double t_s);
    rrs::JointPos errors(double t_s) const;
    /// Ignores the TCP.
    bool is_in_position(const rrs::JointPos& errors) const;
    /// Returns the time that an error needs to decay to 1e-8 of itself.
    double longest_s() const { return settling_time_s_; }

  private:
    void on_set_point_step(const dynamics::SetPointStep& step, const StepHandler& on_step);
    void enter_programmed_path(const motion::Segment& segment);
    std::optional<double> program_distance_mm(const FollowingInstant& instant);
    void change_tcp(std::uint16_t tcp);
    SetPointPath::EndPoint end_state(const motion::JointState& state, double duration_s) const;

    FollowingSetup setup_;
    dynamics::ServoMotion servos_;
    WorkpieceTcp tcp_;
    std::uint16_t tcp_index_ = 0;
    double settling_time_s_ = 0;
    SetPointPath set_point_path_;
    ProgrammedPath* program_ = nullptr;
    bool program_settling_ = false;
    bool tcp_rotates_ = false;   // the TCP, in this segment
    bool extends_line_ = false;  // the last part of the path is a line of this segment
    bool settling_ = false;      // after a change of the TCP
};

}  // namespace gsim::simulation
